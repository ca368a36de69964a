// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "transform/decimal_number.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace lamina {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

constexpr std::array<double, 20> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                            1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
constexpr std::size_t kExactDigits = 15;  // below 2^53: the quotient of two exact doubles is the nearest one

constexpr double kNearTie = 1e-4;  // of the last decimal; far above the rounding of products below 1e10

/// By the exact digits of the double, ties to even, as C and Python print.
void appendExactly(std::string& out, double value, int decimals) {
  std::array<char, 64> text;
  char* end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals).ptr;
  const std::string_view written(text.data(), static_cast<std::size_t>(end - text.data()));
  const bool is_zero = written.find_first_not_of("-0.") == std::string_view::npos;
  out.append(is_zero && written.front() == '-' ? written.substr(1) : written);
}

}  // namespace

DecimalNumber readDecimal(std::string_view text) {
  std::size_t at = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const std::size_t first = at;
  std::uint64_t digits = 0;
  for (; at < text.size() && isDigit(text[at]); ++at)
    digits = digits * 10 + static_cast<std::uint64_t>(text[at] - '0');
  std::size_t count = at - first;
  std::size_t decimals = 0;
  if (at < text.size() && text[at] == '.') {
    const std::size_t point = at++;
    for (; at < text.size() && isDigit(text[at]); ++at)
      digits = digits * 10 + static_cast<std::uint64_t>(text[at] - '0');
    decimals = at - point - 1;
    count += decimals;
  }
  if (count == 0) return {};
  double value = 0.0;
  if (count <= kExactDigits)
    value = static_cast<double>(digits) / kPowers[decimals];
  else
    std::from_chars(text.data() + first, text.data() + at, value, std::chars_format::fixed);
  return {text[0] == '-' ? -value : value, at};
}

void appendFixed(std::string& out, double value, int decimals) {
  const double scaled = std::abs(value) * kPowers[static_cast<std::size_t>(decimals)];
  auto units = static_cast<std::uint64_t>(scaled);
  const double rest = scaled - static_cast<double>(units);
  // The product is rounded itself: whether a value is above a tie only its exact digits tell.
  if (std::abs(rest - 0.5) < kNearTie) return appendExactly(out, value, decimals);
  units += rest > 0.5 ? 1 : 0;
  std::array<char, 32> text;
  std::size_t at = text.size();
  const bool is_negative = value < 0.0 && units != 0;
  for (int i = 0; i < decimals; ++i, units /= 10) text[--at] = static_cast<char>('0' + units % 10);
  if (decimals > 0) text[--at] = '.';
  do {
    text[--at] = static_cast<char>('0' + units % 10);
    units /= 10;
  } while (units != 0);
  if (is_negative) text[--at] = '-';
  out.append(text.data() + at, text.size() - at);
}

}  // namespace lamina
