// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <string>

namespace lamina {

/// What the module `sha256` offers: OpenSSL's digest, which only jobs with a progress file need.
struct Sha256Module {
  /// 64 hexadecimal digits of all that is left in the stream.
  /// @throws FileError if OpenSSL refuses
  std::string (*digestOf)(std::istream& text) = nullptr;
};

}  // namespace lamina
