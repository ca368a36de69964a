// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/decimals.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace lamina {
namespace {

constexpr std::size_t kNumberRoom = 400;  // any double with a few decimals

}  // namespace

void appendDecimals(std::string& text, double value, int decimals) {
  char digits[kNumberRoom];
  const char* begin = digits;
  const char* end =
      std::to_chars(digits, digits + kNumberRoom, value, std::chars_format::fixed, decimals).ptr;
  if (*begin == '-' && std::all_of(begin + 1, end, [](char c) { return c == '0' || c == '.'; })) ++begin;
  text.append(begin, end);
}

void appendShortest(std::string& text, double value) {
  char digits[kNumberRoom];
  text.append(digits, std::to_chars(digits, digits + kNumberRoom, value, std::chars_format::fixed).ptr);
}

std::string shortestText(double value) {
  std::string text;
  appendShortest(text, value);
  return text;
}

std::string significantText(double value, int digits) {
  char text[kNumberRoom];
  return {text, std::to_chars(text, text + kNumberRoom, value, std::chars_format::general, digits).ptr};
}

std::string decimalText(double value, int decimals) {
  std::string text;
  appendDecimals(text, value, decimals);
  return text;
}

std::string trimmedDecimals(double value, int decimals) {
  std::string text = decimalText(value, decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace lamina
