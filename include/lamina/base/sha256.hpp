// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace lamina {

/// Function that copies the next bytes into a buffer of that size and returns their number; 0 at the end.
using ByteSource = std::function<std::size_t(char* buffer, std::size_t size)>;

/// SHA-256 of all bytes, as 64 hexadecimal digits. Source: FIPS 180-4, by OpenSSL.
/// @throws FileError if OpenSSL cannot be loaded or refuses
std::string sha256Of(const ByteSource& source);
std::string sha256Of(std::string_view bytes);

/// SHA-256 of the bytes of a file, as 64 hexadecimal digits.
/// @throws FileError if the file cannot be read, or as `sha256Of`
std::string sha256OfFile(const std::string& path);

}  // namespace lamina
