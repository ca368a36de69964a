// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/gcode_block.hpp"

#include <cmath>
#include <string>

#include "gcode_rewrite/decimal_number.hpp"
#include "lamina/base/characters.hpp"
#include "lamina/base/error.hpp"
#include "program/gcode/plain_command.hpp"

namespace lamina {
namespace {

constexpr double kLargest = 1e7;  // mm: 10 km

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::size_t skipSpace(std::string_view text, std::size_t at) {
  while (at < text.size() && isSpace(text[at])) ++at;
  return at;
}

/// Whether the words of a G command are read.
bool movesOrSets(int code) { return (code >= 0 && code <= 3) || code == 10 || code == 28 || code == 92; }

}  // namespace

bool GcodeBlock::hasAny(std::string_view letters) const {
  for (const char letter : letters)
    if (find(letter) != nullptr) return true;
  return false;
}

void GcodeBlock::refuse(std::string_view what, std::size_t at) const {
  throw InvalidProgram("line " + std::to_string(number_) + ": " + std::string(what) + " at " +
                       quotation_.of(text_.substr(at)));
}

LineStart GcodeBlock::read(std::string_view line, std::size_t number) {
  number_ = number;
  take(line);
  if (!quotation_.isRecognised() && isPlainCommand(line)) quotation_.recognise();
  return start_;
}

LineStart GcodeBlock::take(std::string_view line) {
  text_ = line;
  comment_ = {};
  code_ = -1;
  count_ = 0;
  index_.fill(kNoWord);
  std::size_t at = skipSpace(line, 0);
  words_end_ = at;
  if (at == line.size()) return start_ = LineStart::Blank;
  if (line[at] == ';') {
    comment_ = line.substr(at + 1);
    return start_ = LineStart::Comment;
  }
  if (upper(line[at]) == 'N') {
    const std::size_t digits = skipSpace(line, at + 1);
    const DecimalNumber sequence = readDecimal(line.substr(digits));
    if (sequence.length > 0) at = skipSpace(line, digits + sequence.length);
    if (at == line.size()) return start_ = LineStart::Other;
  }
  const char letter = upper(line[at]);
  const std::size_t value = skipSpace(line, at + 1);
  const DecimalNumber number_after = readDecimal(line.substr(value));
  start_ = LineStart::Other;
  if (number_after.length == 0) return start_;
  if (letter == 'G' || letter == 'M') {
    start_ = letter == 'G' ? LineStart::G : LineStart::M;
    setCode(number_after.value);
    words_end_ = value + number_after.length;
    if (letter == 'G' && movesOrSets(code_)) readWords(words_end_);
  } else if (std::string_view("XYZEFIJKR").find(letter) != std::string_view::npos) {
    start_ = LineStart::Coordinate;
  }
  return start_;
}

void GcodeBlock::setCode(double number) {
  const int whole = number >= 0.0 && number <= 9999.0 ? static_cast<int>(number) : -1;
  code_ = static_cast<double>(whole) == number ? whole : -1;
}

void GcodeBlock::readWords(std::size_t at) {
  while ((at = skipSpace(text_, at)) < text_.size()) {
    if (text_[at] == ';') {
      comment_ = text_.substr(at + 1);
      return;
    }
    if (text_[at] == '*') refuse("a checksum would not hold after the rewriting; take the checksums off", at);
    if (text_[at] == '(') {
      const std::size_t close = text_.find(')', at);
      if (close == std::string_view::npos) refuse("comment is not closed", at);
      at = close + 1;
      continue;
    }
    if (!isLetter(text_[at])) refuse("unexpected character", at);
    at = readWord(at);
  }
}

std::size_t GcodeBlock::readWord(std::size_t at) {
  const char letter = upper(text_[at]);
  std::uint8_t& index = index_[static_cast<std::size_t>(letter - 'A')];
  if (letter == 'G' || letter == 'M') refuse("two commands in one line", at);
  if (index != kNoWord) refuse("a word stands twice", at);
  const std::size_t from = skipSpace(text_, at + 1);
  const DecimalNumber number = readDecimal(text_.substr(from));
  PlacedWord& word = words_[count_];
  word.letter = letter;
  word.has_value = number.length > 0;
  word.value = number.value;
  word.begin = at;
  word.end = number.length > 0 ? from + number.length : at + 1;
  if (!(std::abs(word.value) <= kLargest)) refuse("number beyond 1e7", at);
  const bool goes_on =
      word.end < text_.size() && (text_[word.end] == '.' || text_[word.end] == '-' || text_[word.end] == '+');
  if (goes_on) refuse("bad number", at);
  index = static_cast<std::uint8_t>(count_++);
  words_end_ = word.end;
  return word.end;
}

}  // namespace lamina
