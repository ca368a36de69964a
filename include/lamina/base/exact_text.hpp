// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <string>

namespace lamina {

/// The shortest text that reads back as the same number, with an exponent where that is shorter: "0.1",
/// "1e-07", "inf". The same in every locale.
inline std::string exactText(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// Appends `exactText(value)` to a text.
inline void appendExact(std::string& text, double value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

}  // namespace lamina
