// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/number_text.hpp"

#include <charconv>

namespace lamina {

std::string numberText(double value) {
  constexpr int kDigits = 6;
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, kDigits).ptr;
  return {text, end};
}

}  // namespace lamina
