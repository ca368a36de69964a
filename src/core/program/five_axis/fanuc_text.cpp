// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/five_axis/fanuc_text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "base/decimals.hpp"
#include "lamina/base/characters.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr std::string_view kPointed = "XYZABCUVWF";  // words that lengths, angles and feeds stand in
constexpr std::string_view kOfNames = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-_.";
constexpr std::string_view kOfComments = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .,:=_-+*/#<>";
constexpr std::size_t kLongestFanucName = 32;
constexpr int kMostOfFourDigits = 9999;
constexpr std::ptrdiff_t kMostFanucDigits = 8;  // of a word, before and behind its point

std::string smallText(std::string_view text) {
  std::string lowered(text);
  std::transform(lowered.begin(), lowered.end(), lowered.begin(), lower);
  return lowered;
}

std::string bracketed(std::string_view comment) {
  std::string text = "(";
  for (const char c : trimmed(comment)) {
    const char known = upper(c);
    text += kOfComments.find(known) != std::string_view::npos ? known : '-';
  }
  return text + ")";
}

/// The word as it is, or its number with as many decimals as there is room for.
std::string withinDigits(std::string_view word) {
  std::string text(word);
  const auto digits = [](const std::string& of) { return std::count_if(of.begin(), of.end(), isDigit); };
  if (digits(text) <= kMostFanucDigits) return text;
  const std::ptrdiff_t whole = digits(text.substr(0, text.find('.')));
  const std::ptrdiff_t decimals = std::max<std::ptrdiff_t>(kMostFanucDigits - whole, 0);
  double value = 0.0;
  std::from_chars(text.data() + 1, text.data() + text.size(), value);
  return text.front() + trimmedDecimals(value, static_cast<int>(decimals));
}

std::string pointed(std::string_view words) {
  std::string text;
  while (!words.empty()) {
    const std::size_t blank = std::min(words.find(' '), words.size());
    const std::string_view word = words.substr(0, blank);
    const bool is_length = word.size() > 1 && kPointed.find(word.front()) != std::string_view::npos;
    const std::string written = is_length ? withinDigits(word) : std::string(word);
    text += written;
    if (is_length && written.find('.') == std::string::npos) text += '.';
    if (blank < words.size()) text += ' ';
    words.remove_prefix(std::min(blank + 1, words.size()));
  }
  return text;
}

std::string fanucLine(std::string_view line) {
  const std::size_t mark = line.find(';');
  if (mark == std::string_view::npos)
    return line.find('(') == std::string_view::npos ? pointed(line) : std::string(line);
  const std::string words = pointed(trimmed(line.substr(0, mark)));
  return words + (words.empty() ? "" : " ") + bracketed(line.substr(mark + 1));
}

/// A comment as it was written: a key keeps its capitals, what is chosen from a list has none, nor has a
/// sentence.
std::string fromCapitals(std::string_view comment, bool is_remark) {
  const std::size_t colon = comment.find(':');
  const std::string_view key = comment.substr(0, std::min(colon, comment.size()));
  if (colon == std::string_view::npos) return (is_remark ? "" : " ") + smallText(comment);
  const std::string_view value = comment.substr(colon + 1);
  const std::string head = std::string(key) + ":";
  if (key == "TYPE") return head + smallText(value);
  if (key != "FIVE_AXIS") return head + std::string(value);
  const std::size_t blank = std::min(value.find(' '), value.size());
  return head + smallText(value.substr(0, blank)) + std::string(value.substr(blank));
}

}  // namespace

std::string fanucText(std::string_view lines) {
  std::string text;
  text.reserve(lines.size() + lines.size() / 8);
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    text += fanucLine(lines.substr(0, end)) + "\n";
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return text;
}

std::string fromFanucText(std::string_view line) {
  const std::size_t open = line.find('(');
  const std::size_t close = line.rfind(')');
  if (open == std::string_view::npos || close == std::string_view::npos || close < open)
    return std::string(line);
  const std::string_view words = trimmed(line.substr(0, open));
  return std::string(words) + (words.empty() ? "" : " ") + ";" +
         fromCapitals(line.substr(open + 1, close - open - 1), !words.empty());
}

std::string fanucProgramName(const FiveAxisSettings& settings) {
  const std::string& name = settings.program_name;
  if (name.empty()) {
    char number[16];
    std::snprintf(number, sizeof(number), settings.program_number > kMostOfFourDigits ? "O%08d" : "O%04d",
                  settings.program_number);
    return number;
  }
  if (name.size() > kLongestFanucName || name.find_first_not_of(kOfNames) != std::string::npos)
    throw InvalidConfig("five_axis.program_name is '" + name +
                        "'; expected at most 32 characters of A-Z, 0-9, +, -, _ and .");
  return "<" + name + ">";
}

}  // namespace lamina
