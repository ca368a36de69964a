// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/decimal_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kDigits = 24;
constexpr double kMostUnits = 1e15;      // of the last decimal: what a double still counts one by one
constexpr double kNearTie = 1e-4;        // of the last decimal; far above the rounding of products
constexpr double kRoundedFinely = 1e10;  // that are no greater than this

/// By the exact digits of the double, ties to even, as C and Python print.
char* writeExactly(char* out, double value, int decimals) {
  char* end = std::to_chars(out, out + kMostFixed, value, std::chars_format::fixed, decimals).ptr;
  const std::string_view written(out, static_cast<std::size_t>(end - out));
  const bool is_zero = written.find_first_not_of("-0.") == std::string_view::npos;
  return is_zero && *out == '-' ? std::copy(out + 1, end, out) : end;
}

}  // namespace

DecimalNumber readLongDecimal(std::string_view text) {
  const std::size_t first = text[0] == '-' || text[0] == '+' ? 1 : 0;
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + first, end, value, std::chars_format::fixed);
  const bool is_huge = read.ec != std::errc{} && text.find_first_of("123456789") < text.find('.');
  if (is_huge) value = std::numeric_limits<double>::infinity();
  return {text[0] == '-' ? -value : value, static_cast<std::size_t>(read.ptr - text.data())};
}

char* writeFixed(char* out, double value, int decimals) {
  const double scaled = std::abs(value) * kPowersOfTen[static_cast<std::size_t>(decimals)];
  if (!(scaled < kMostUnits))
    throw InvalidInput("a coordinate, E or F comes to " + numberText(value) +
                       ", which is too much to be written; expected less than 1e9");
  auto units = static_cast<std::uint64_t>(scaled);
  const double rest = scaled - static_cast<double>(units);
  // The product itself is rounded: only the exact digits show whether a value is above a tie.
  if (std::abs(rest - 0.5) < kNearTie || scaled > kRoundedFinely) return writeExactly(out, value, decimals);
  units += rest > 0.5 ? 1 : 0;
  if (value < 0.0 && units != 0) *out++ = '-';
  std::array<char, 2 * kDigits> digits;
  char* const end = digits.data() + kDigits;
  char* at = end;
  for (int i = 0; i < decimals; ++i, units /= 10) *--at = static_cast<char>('0' + units % 10);
  if (decimals > 0) *--at = '.';
  do {
    *--at = static_cast<char>('0' + units % 10);
    units /= 10;
  } while (units != 0);
  std::memcpy(out, at, kDigits);  // a fixed length is one move, and there is room
  return out + (end - at);
}

void appendFixed(std::string& out, double value, int decimals) {
  std::array<char, kMostFixed> text;
  out.append(text.data(), writeFixed(text.data(), value, decimals));
}

}  // namespace lamina
