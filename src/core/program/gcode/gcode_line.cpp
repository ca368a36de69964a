// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/gcode_line.hpp"

#include <charconv>
#include <cmath>
#include <string>

#include "lamina/base/characters.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "program/gcode/plain_command.hpp"

namespace lamina {
namespace {

constexpr double kLargest = 1e9;

bool isInterpreted(char letter, std::optional<double> value) {
  if (letter == 'G') {
    if (!value) return true;  // refused as a command without number
    const double code = std::floor(*value);
    return code <= 6.0 || (code >= 17.0 && code <= 21.0) || code == 28.0 || (code >= 90.0 && code <= 92.0);
  }
  if (letter == 'M') return value && (*value == 82.0 || *value == 83.0);
  return letter != 'T' && std::string_view("XYZEFIJKRABCUVW").find(letter) != std::string_view::npos;
}

/// A word in letters, such as START_PRINT, instead of a letter and a number.
bool isNamedCommand(std::string_view text) {
  std::size_t length = 0;
  bool has_underscore = false;
  while (length < text.size() && (isLetter(text[length]) || text[length] == '_'))
    has_underscore |= text[length++] == '_';
  const bool is_axis = std::string_view("XYZEFIJKR").find(upper(text.front())) != std::string_view::npos;
  return length > 1 && (has_underscore || (length >= 4 && !is_axis));
}

}  // namespace

const GcodeLine& GcodeLineParser::parse(std::string_view text, std::size_t number) {
  line_.number = number;
  take(number == 1 ? withoutUtf8Mark(text) : text);
  if (!quotation_.isRecognised() && isPlainCommand(text)) quotation_.recognise();
  return line_;
}

void GcodeLineParser::refuse(std::string_view what, std::string_view at) const {
  throw InvalidProgram("line " + std::to_string(line_.number) + ": " + std::string(what) + " at " +
                       quotation_.of(at));
}

void GcodeLineParser::take(std::string_view text) {
  line_.sequence.reset();
  line_.words.clear();
  line_.comments.clear();
  line_.is_other = false;
  text = withoutComment(text);
  text = withoutSequence(withoutChecksum(text));
  line_.command = text;
  if (text.empty()) return;
  line_.is_other = text.front() != '(' && startsOther(text);
  if (!line_.is_other) parseWords(text);
}

std::string_view GcodeLineParser::withoutComment(std::string_view text) {
  const std::size_t semicolon = text.find(';');
  if (semicolon == std::string_view::npos) return text;
  line_.comments.push_back(trimmed(text.substr(semicolon + 1)));
  return text.substr(0, semicolon);
}

std::string_view GcodeLineParser::withoutChecksum(std::string_view text) const {
  const std::size_t star = text.rfind('*');
  if (star == std::string_view::npos) return text;
  const std::string_view digits = trimmed(text.substr(star + 1));
  unsigned stated = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), stated);
  if (digits.empty() || result.ec != std::errc{} || result.ptr != digits.data() + digits.size()) {
    const std::string_view start = trimmed(text);
    if (!start.empty() && upper(start.front()) == 'N') refuse("bad checksum", text.substr(star));
    return text;
  }
  unsigned actual = 0;
  for (const char c : text.substr(0, star)) actual ^= static_cast<unsigned char>(c);
  if (actual != stated)
    throw InvalidProgram("line " + std::to_string(line_.number) + ": checksum is " + std::to_string(stated) +
                         "; the line's bytes give " + std::to_string(actual));
  return text.substr(0, star);
}

std::string_view GcodeLineParser::withoutSequence(std::string_view text) {
  text = trimmed(text);
  if (text.size() < 2 || upper(text.front()) != 'N' || !(isDigit(text[1]) || text[1] == '-')) return text;
  std::int64_t sequence = 0;
  const auto result = std::from_chars(text.data() + 1, text.data() + text.size(), sequence);
  if (result.ec != std::errc{}) refuse("bad line number", text);
  line_.sequence = sequence;
  return trimmed(text.substr(static_cast<std::size_t>(result.ptr - text.data())));
}

void GcodeLineParser::parseWords(std::string_view text) {
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    if (text.front() == '(') {
      const std::size_t close = text.find(')');
      if (close == std::string_view::npos) refuse("comment is not closed", text);
      line_.comments.push_back(trimmed(text.substr(1, close - 1)));
      text.remove_prefix(close + 1);
      continue;
    }
    if (!isLetter(text.front())) refuse("a letter is expected, as in X10.5,", text);
    const char letter = upper(text.front());
    text = trimmed(text.substr(1));
    line_.words.push_back({letter, takeNumber(text)});
  }
}

bool GcodeLineParser::startsOther(std::string_view text) const {
  if (!isLetter(text.front())) return text.front() == '%' || text.front() == '$';
  if (isNamedCommand(text)) return true;
  const char letter = upper(text.front());
  text = trimmed(text.substr(1));
  return !isInterpreted(letter, takeNumber(text));
}

std::optional<double> GcodeLineParser::takeNumber(std::string_view& text) const {
  if (text.empty()) return std::nullopt;
  const bool has_sign = text.front() == '+' || text.front() == '-';
  const std::size_t first = has_sign ? 1 : 0;
  if (first == text.size() || !(isDigit(text[first]) || text[first] == '.')) {
    if (has_sign) refuse("bad number", text);
    return std::nullopt;
  }
  double value = 0.0;
  const char* begin = text.data() + (text.front() == '+' ? 1 : 0);
  const auto result = std::from_chars(begin, text.data() + text.size(), value, std::chars_format::fixed);
  if (result.ec != std::errc{} || !(std::abs(value) <= kLargest)) refuse("bad number", text);
  text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()));
  return value;
}

}  // namespace lamina
