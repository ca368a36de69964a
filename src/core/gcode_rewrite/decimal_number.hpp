// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace lamina {

/// A number read from the beginning of a text.
struct DecimalNumber {
  double value = 0.0;
  std::size_t length = 0;  ///< number of characters read; 0 if the text does not begin with a number
};

inline constexpr std::array<double, 16> kPowersOfTen = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                        1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

/// Reads a number [+-]digits[.digits] or .digits of any length, as the nearest double; infinite beyond the
/// greatest double.
DecimalNumber readLongDecimal(std::string_view text);

/// Reads a number [+-]digits[.digits] or .digits, as the nearest double. Exponents are not read, as E is a
/// letter of G-code.
inline DecimalNumber readDecimal(std::string_view text) {
  constexpr std::ptrdiff_t kExactDigits =
      15;  // below 2^53: the quotient of two exact doubles is the nearest one
  const char* const end = text.data() + text.size();
  const char* at = text.data();
  const bool is_negative = at != end && *at == '-';
  if (is_negative || (at != end && *at == '+')) ++at;
  std::uint64_t digits = 0;
  const auto takeDigits = [&] {
    for (; at != end; ++at) {
      const auto digit = static_cast<unsigned>(*at - '0');
      if (digit > 9) break;
      digits = digits * 10 + digit;
    }
  };
  const char* const first = at;
  takeDigits();
  std::ptrdiff_t count = at - first;
  std::ptrdiff_t decimals = 0;
  if (at != end && *at == '.') {
    const char* const point = at++;
    takeDigits();
    decimals = at - point - 1;
    count += decimals;
  }
  if (count == 0) return {};
  if (count > kExactDigits) return readLongDecimal(text);
  const double value = static_cast<double>(static_cast<std::int64_t>(digits)) /
                       kPowersOfTen[static_cast<std::size_t>(decimals)];
  return {is_negative ? -value : value, static_cast<std::size_t>(at - text.data())};
}

/// Number of characters for which `writeFixed` needs room.
inline constexpr std::size_t kMostFixed = 32;

/// Writes a number with exactly that many decimals, rounded to nearest by its exact value; never -0.
/// @param decimals  0 to 6
/// @return one past the last character written
/// @throws InvalidInput if the number has more than 15 digits, or is not finite
char* writeFixed(char* out, double value, int decimals);

/// Appends a number as `writeFixed` writes it.
void appendFixed(std::string& out, double value, int decimals);

}  // namespace lamina
