// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/program_identity.hpp"

#include <boost/crc.hpp>
#include <charconv>
#include <cstdio>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"

namespace lamina {
namespace {

std::string hexadecimal(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "%08x", value);
  return text;
}

std::uint32_t crcFromText(const std::string& text) {
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value, 16);
  if (text.size() == 8 && read.ec == std::errc() && read.ptr == end) return value;
  throw InvalidInput("crc32 is '" + text + "'; expected eight hexadecimal digits");
}

}  // namespace

ProgramIdentity identityOfText(const std::string& name, std::string_view text) {
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), text.size());
  return {name, text.size(), crc.checksum()};
}

ProgramIdentity identityOfFile(const std::string& path) {
  constexpr std::size_t kPiece = 1 << 20;
  InputFile file(path);
  std::vector<char> piece(kPiece);
  boost::crc_32_type crc;
  ProgramIdentity identity{path, 0, 0};
  for (std::size_t read = kPiece; read == kPiece;) {
    read = file.read(piece.data(), kPiece);
    crc.process_bytes(piece.data(), read);
    identity.bytes += read;
  }
  identity.crc32 = crc.checksum();
  return identity;
}

void requireWhole(const ProgramIdentity& arrived, std::uint64_t bytes, const std::string& crc32) {
  const std::uint32_t expected = crcFromText(crc32);
  if (arrived.bytes != bytes)
    throw InvalidProgram(arrived.name + " has " + std::to_string(arrived.bytes) + " bytes; expected " +
                         std::to_string(bytes) + ": it was not transferred whole");
  if (arrived.crc32 != expected)
    throw InvalidProgram(arrived.name + " has the CRC-32 " + hexadecimal(arrived.crc32) + "; expected " +
                         hexadecimal(expected) + ": it was changed on its way");
}

}  // namespace lamina
