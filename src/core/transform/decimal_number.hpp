// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lamina {

/// A number read from the front of a text.
struct DecimalNumber {
  double value = 0.0;
  std::size_t length = 0;  ///< characters read; 0 if the text does not start with a number
};

/// Reads [+-]digits[.digits], or .digits; nearest double. No exponent: E is a letter of its own.
DecimalNumber readDecimal(std::string_view text);

/// Appends the number with exactly so many decimals, rounded to nearest, never as -0.
/// @param decimals  0 to 6; the value must be below 1e12
void appendFixed(std::string& out, double value, int decimals);

}  // namespace lamina
