// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/sha256.hpp"

namespace lamina {

/// Functions of the module `sha256`: OpenSSL's digest, which is needed only for programs that are kept or
/// uploaded, and for cells.
struct Sha256Module {
  std::string (*digest_of)(const ByteSource& source) = nullptr;
};

}  // namespace lamina
