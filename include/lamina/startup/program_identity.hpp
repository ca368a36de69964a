// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lamina {

/// Distinguishes a program that arrived whole from a truncated one, and from any other program.
struct ProgramIdentity {
  std::string name;  ///< path of a file, or id of a toolpath
  std::uint64_t bytes = 0;
  std::uint32_t crc32 = 0;  ///< of ISO 3309 and zip, as `crc32` and `gzip -lv` report it

  friend bool operator==(const ProgramIdentity& a, const ProgramIdentity& b) {
    return a.name == b.name && a.bytes == b.bytes && a.crc32 == b.crc32;
  }
};

ProgramIdentity identityOfText(const std::string& name, std::string_view text);

/// Reads the file once, piece by piece.
/// @throws FileError if it cannot be read
ProgramIdentity identityOfFile(const std::string& path);

/// Checks a program that has arrived against what its sender reports.
/// @param crc32  eight hexadecimal digits
/// @throws InvalidInput if the checksum is none
/// @throws InvalidProgram with both lengths or both checksums if they differ
void requireWhole(const ProgramIdentity& arrived, std::uint64_t bytes, const std::string& crc32);

}  // namespace lamina
