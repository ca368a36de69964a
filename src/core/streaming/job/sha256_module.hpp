// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace lamina {

/// Puts the next bytes into a buffer of that size, and gives their number; 0 at the end.
using ByteSource = std::function<std::size_t(char* buffer, std::size_t size)>;

/// What the module `sha256` offers: OpenSSL's digest, which only kept or uploaded programs need.
struct Sha256Module {
  std::string (*digest_of)(const ByteSource& source) = nullptr;
};

/// 64 hexadecimal digits of all bytes.
/// @throws FileError if OpenSSL refuses
std::string sha256Of(const ByteSource& source);

}  // namespace lamina
