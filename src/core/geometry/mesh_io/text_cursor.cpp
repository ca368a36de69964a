// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text_cursor.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
bool isSpace(char c) { return isBlank(c) || c == '\n'; }

}  // namespace

std::string_view TextCursor::wordInLine() {
  while (position_ < text_.size() && isBlank(text_[position_])) ++position_;
  const std::size_t start = position_;
  while (position_ < text_.size() && !isSpace(text_[position_])) ++position_;
  return text_.substr(start, position_ - start);
}

std::string_view TextCursor::word() {
  while (position_ < text_.size() && isSpace(text_[position_])) ++position_;
  return wordInLine();
}

void TextCursor::skipLine() {
  const std::size_t end = text_.find('\n', position_);
  position_ = end == std::string_view::npos ? text_.size() : end + 1;
}

double TextCursor::number() { return parse(word()); }
double TextCursor::numberInLine() { return parse(wordInLine()); }

double TextCursor::parse(std::string_view word) const {
  if (word.empty()) refuse("ends where a number is expected");
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const char* end = word.data() + word.size();
  double value = 0.0;
  const auto result = std::from_chars(word.data() + (has_plus ? 1 : 0), end, value);
  const bool is_tiny =
      result.ec == std::errc::result_out_of_range && result.ptr == end && word.find("e-") != word.npos;
  if (is_tiny) return 0.0;
  if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value))
    refuse(quoted(word) + " where a finite number is expected");
  return value;
}

void TextCursor::refuse(const std::string& what) const {
  const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(position_, text_.size()));
  const auto line = 1 + std::count(text_.begin(), end, '\n');
  throw InvalidMesh(name_ + ":" + std::to_string(line) + ": " + what);
}

bool equalsIgnoringCase(std::string_view word, std::string_view lower_case) {
  return word.size() == lower_case.size() &&
         std::equal(word.begin(), word.end(), lower_case.begin(), [](char a, char b) {
           return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
         });
}

}  // namespace lamina
