// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Appends a value with exactly that many decimals; never -0.
void appendDecimals(std::string& text, double value, int decimals);

/// Appends the shortest decimal text that reads back as the same value.
void appendShortest(std::string& text, double value);

/// The shortest decimal text without an exponent that reads back as the same value.
std::string shortestText(double value);

/// A value with at most that many significant digits, without trailing zeros: 0.125, 1.2e-05.
std::string significantText(double value, int digits);

/// A value with exactly that many decimals; never -0.
std::string decimalText(double value, int decimals);

/// A value with at most that many decimals, without trailing zeros: 0.15.
std::string trimmedDecimals(double value, int decimals);

}  // namespace lamina
