// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Appends the value with that many decimals, all of them; never -0.
void appendDecimals(std::string& text, double value, int decimals);

/// Appends the shortest digits that give the value back.
void appendShortest(std::string& text, double value);

/// The shortest digits that give the value back, without an exponent.
std::string shortestText(double value);

/// The value to that many significant digits, without zeros at the end: 0.125, 1.2e-05.
std::string significantText(double value, int digits);

/// The value with that many decimals, all of them; never -0.
std::string decimalText(double value, int decimals);

/// The value with that many decimals at most, without zeros at the end: 0.15.
std::string trimmedDecimals(double value, int decimals);

}  // namespace lamina
