// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_words.hpp"

#include <algorithm>

#include "lamina/base/characters.hpp"

namespace lamina {
namespace {

std::string_view withoutBlanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
}

/// Reads a number without exponent, and takes it from the text. Faster than the library's, which minds the
/// locale.
std::optional<double> takeNumber(std::string_view& text) {
  text = withoutBlanks(text);
  const bool is_negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  double value = 0.0;
  double scale = 1.0;
  bool has_digit = false;
  bool has_point = false;
  for (; !text.empty(); text.remove_prefix(1)) {
    const char c = text.front();
    if (c == ' ' || c == '\t') continue;
    if (c == '.' && !has_point) {
      has_point = true;
    } else if (isDigit(c)) {
      has_digit = true;
      value = 10.0 * value + (c - '0');
      if (has_point) scale *= 10.0;
    } else {
      break;
    }
  }
  if (!has_digit) return std::nullopt;
  return (is_negative ? -value : value) / scale;
}

}  // namespace

std::optional<GrblWords> GrblWords::of(std::string_view line) {
  GrblWords found;
  for (line = withoutBlanks(line); !line.empty(); line = withoutBlanks(line)) {
    constexpr char kToUpper = 'a' - 'A';
    char letter = line.front();
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - kToUpper);
    if (letter < 'A' || letter > 'Z' || found.count_ == found.words_.size()) return std::nullopt;
    line.remove_prefix(1);
    const auto value = takeNumber(line);
    if (!value) return std::nullopt;
    found.words_[found.count_++] = {letter, *value};
  }
  return found;
}

}  // namespace lamina
