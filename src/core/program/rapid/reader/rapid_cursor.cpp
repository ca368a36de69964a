// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/reader/rapid_cursor.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "program/rapid/rapid_words.hpp"

namespace lamina {
namespace {

constexpr double kLargest = 1e10;  // an axis that is not there is at 9e+09

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

void RapidCursor::skipBlanks() {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '\n') {
      ++line_;
    } else if (c == '!') {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      std::string_view comment = text_.substr(at_ + 1, end - at_ - 1);
      if (!comment.empty() && comment.back() == '\r') comment.remove_suffix(1);
      comments_.push_back({comment, line_});
      at_ = end - 1;
    } else if (c != ' ' && c != '\t' && c != '\r') {
      return;
    }
  }
}

bool RapidCursor::take(std::string_view symbol) {
  if (text_.substr(at_, symbol.size()) != symbol) return false;
  at_ += symbol.size();
  skipBlanks();
  return true;
}

std::size_t RapidCursor::nameLength() const {
  std::size_t length = 0;
  while (at_ + length < text_.size() && isNameCharacter(text_[at_ + length])) ++length;
  return length;
}

bool RapidCursor::takeWord(std::string_view word) {
  const std::size_t length = nameLength();
  if (length != word.size() || lowerCase(text_.substr(at_, length)) != word) return false;
  at_ += length;
  skipBlanks();
  return true;
}

void RapidCursor::expect(std::string_view symbol) {
  if (!take(symbol)) refuse("'" + std::string(symbol) + "'");
}

void RapidCursor::expectWord(std::string_view word) {
  if (!takeWord(word)) refuse("'" + std::string(word) + "'");
}

std::string RapidCursor::takeName(std::string_view expected) {
  const std::size_t length = nameLength();
  if (length == 0 || (text_[at_] >= '0' && text_[at_] <= '9')) refuse(expected);
  std::string name = lowerCase(text_.substr(at_, length));
  at_ += length;
  skipBlanks();
  return name;
}

double RapidCursor::takeNumber(std::string_view expected) {
  const char* end = text_.data() + text_.size();
  const char* begin = text_.data() + at_;
  double value = 0.0;
  const auto result = std::from_chars(begin, end, value);
  if (result.ec != std::errc{} || !(std::abs(value) <= kLargest)) refuse(expected);
  at_ += static_cast<std::size_t>(result.ptr - begin);
  skipBlanks();
  return value;
}

std::string RapidCursor::takeString(std::string_view expected) {
  if (!isNext('"')) refuse(expected);
  const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
  if (end == std::string_view::npos || text_[end] == '\n') refuse(expected);
  std::string value(text_.substr(at_ + 1, end - at_ - 1));
  at_ = end + 1;
  skipBlanks();
  return value;
}

std::vector<RapidComment> RapidCursor::takeComments() {
  std::vector<RapidComment> taken;
  taken.swap(comments_);
  return taken;
}

void RapidCursor::refuse(std::string_view expected) const {
  const std::string_view found = text_.substr(at_, text_.find('\n', at_) - at_);
  refuseAt(line_, (isAtEnd() ? "the text ends" : "found " + quotation_.of(found)) + "; expected " +
                      std::string(expected));
}

void RapidCursor::refuseAt(std::size_t line, const std::string& what) const {
  throw InvalidProgram("'" + name_ + "' line " + std::to_string(line) + ": " + what);
}

}  // namespace lamina
