// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/reader/line_cursor.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lamina/base/characters.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

bool isWordLetter(char c) { return (lower(c) >= 'a' && lower(c) <= 'z') || c == '_'; }
bool isWordPart(char c) { return isWordLetter(c) || (c >= '0' && c <= '9'); }

bool isSameText(std::string_view a, std::string_view b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

void LineCursor::skipSpace() {
  while (!rest_.empty() && isBlank(rest_.front())) rest_.remove_prefix(1);
}

bool LineCursor::isAtEnd() {
  skipSpace();
  return rest_.empty();
}

bool LineCursor::take(std::string_view text) {
  skipSpace();
  if (!isSameText(rest_.substr(0, text.size()), text)) return false;
  const bool is_word = isWordPart(text.back());
  if (is_word && rest_.size() > text.size() && isWordPart(rest_[text.size()])) return false;
  rest_.remove_prefix(text.size());
  return true;
}

void LineCursor::expect(std::string_view text) {
  if (!take(text)) refuse("'" + std::string(text) + "'");
}

std::string LineCursor::word(const char* expected) {
  skipSpace();
  if (rest_.empty() || !isWordLetter(rest_.front())) refuse(expected);
  const auto end = std::find_if_not(rest_.begin(), rest_.end(), isWordPart);
  std::string word(rest_.begin(), end);
  rest_.remove_prefix(word.size());
  return word;
}

double LineCursor::number(double low, double high, const char* expected) {
  skipSpace();
  std::string_view digits = rest_;
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  double value = 0.0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (result.ec != std::errc{} || !(value >= low && value <= high)) refuse(expected);
  rest_.remove_prefix(static_cast<std::size_t>(result.ptr - rest_.data()));
  return value;
}

int LineCursor::integer(int low, int high, const char* expected) {
  skipSpace();
  int value = 0;
  const auto result = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
  if (result.ec != std::errc{} || value < low || value > high) refuse(expected);
  rest_.remove_prefix(static_cast<std::size_t>(result.ptr - rest_.data()));
  return value;
}

void LineCursor::expectEnd() {
  if (!isAtEnd()) refuse("nothing more on this line");
}

void LineCursor::refuse(const std::string& expected) const { refuse(rest_, expected); }

void LineCursor::refuse(std::string_view found, const std::string& expected) const {
  throw InvalidProgram("'" + file_->name + "' line " + std::to_string(line_) + ": found " +
                       (found.empty() ? "the end of the line" : file_->quotation.of(found)) + "; expected " +
                       expected);
}

std::vector<std::string_view> textLines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace lamina
