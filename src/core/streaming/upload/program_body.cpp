// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/program_body.hpp"

#include <boost/crc.hpp>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/sha256.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

/// How many bytes the character that begins with this one has; 0 if none does.
std::size_t utf8Length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  if (first >= 0xF0 && first < 0xF5) return 4;
  return 0;
}

/// Whether a text is UTF-8, without overlong forms and surrogates [RFC 3629].
bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[i + k]); };
    const std::size_t length = utf8Length(byte(0));
    if (length == 0 || i + length > text.size()) return false;
    for (std::size_t k = 1; k < length; ++k)
      if ((byte(k) & 0xC0U) != 0x80U) return false;
    if (byte(0) == 0xE0 && byte(1) < 0xA0) return false;
    if (byte(0) == 0xED && byte(1) > 0x9F) return false;
    if (byte(0) == 0xF0 && byte(1) < 0x90) return false;
    if (byte(0) == 0xF4 && byte(1) > 0x8F) return false;
    i += length;
  }
  return true;
}

}  // namespace

std::size_t ProgramBody::Reader::read(char* buffer, std::size_t size) {
  text_->read(buffer, static_cast<std::streamsize>(size));
  const auto count = static_cast<std::size_t>(text_->gcount());
  if (count > 0) {
    last_ = buffer[count - 1];
    return count;
  }
  if (last_ == '\n') return 0;
  buffer[0] = last_ = '\n';
  return 1;
}

ProgramBody::ProgramBody(StreamableProgram program) : program_(std::move(program)) {
  checkLines();
  digest();
  if (program_.hasChanged())
    throw InvalidProgram(program_.name() + " was changed after it was checked; nothing was uploaded");
}

/// A printer takes all that stands before a ';' for the command. Where that is not what the program says, it
/// has a comment in parentheses, a line number, a tape mark, or a ';' in a text.
void ProgramBody::checkLines() {
  const auto text = program_.openText();
  ProgramCursor cursor = program_.open();
  auto next = cursor.next();
  const auto ends = std::make_shared<CommandEnds>();
  command_ends_ = ends;
  std::string raw;
  for (std::uint64_t number = 1; std::getline(*text, raw); ++number) {
    if (line_not_utf8_ == 0 && !isUtf8(raw)) line_not_utf8_ = number;
    const std::string_view read = trimmed(std::string_view(raw).substr(0, raw.find(';')));
    const bool has_command = next && cursor.textLine() == number;
    if (read != (has_command ? std::string_view(next->command) : std::string_view())) {
      throw InvalidProgram(
          program_.name() + " line " + std::to_string(number) + ": " + program_.quotation().of(read) +
          " is read otherwise by a printer that reads the file itself; expected comments behind "
          "';', and no line numbers or tape marks");
    }
    if (!has_command) continue;
    outputs_.see(read);
    ends->add(cursor.bytesRead(), next->layer);
    if (read.size() > longest_bytes_) {
      longest_bytes_ = read.size();
      longest_line_ = number;
    }
    next = cursor.next();
  }
}

void ProgramBody::digest() {
  boost::crc_32_type crc;
  Reader reader = open();
  sha256_ = sha256Of([&](char* buffer, std::size_t size) {
    const std::size_t count = reader.read(buffer, size);
    crc.process_bytes(buffer, count);
    bytes_ += count;
    return count;
  });
  crc32_ = crc.checksum();
}

}  // namespace lamina
