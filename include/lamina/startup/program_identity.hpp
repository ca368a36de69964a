// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lamina {

/// Length and checksum of a program, which distinguish a complete program from a truncated one and from any
/// other.
struct ProgramIdentity {
  std::string name;  ///< path of a file, or id of a toolpath
  std::uint64_t bytes = 0;
  std::uint32_t crc32 = 0;  ///< by ISO 3309, as in zip files and as `crc32` and `gzip -lv` report it

  friend bool operator==(const ProgramIdentity& a, const ProgramIdentity& b) {
    return a.name == b.name && a.bytes == b.bytes && a.crc32 == b.crc32;
  }
};

/// The identity of a program held in memory.
ProgramIdentity identityOfText(const std::string& name, std::string_view text);

/// The identity of a file, which is read once, piece by piece.
/// @throws FileError if it cannot be read
ProgramIdentity identityOfFile(const std::string& path);

/// Checks a program that has arrived against the length and checksum that its sender states.
/// @param crc32  eight hexadecimal digits
/// @throws InvalidInput if `crc32` is no checksum
/// @throws InvalidProgram naming both lengths or both checksums, if they differ
void requireWhole(const ProgramIdentity& arrived, std::uint64_t bytes, const std::string& crc32);

}  // namespace lamina
