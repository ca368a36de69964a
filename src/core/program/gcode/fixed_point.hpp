// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cstdint>

namespace lamina {

/// The number of units of 1/scale that is nearest to a value; |value| * scale must be below 2^62.
inline std::int64_t toUnits(double value, double scale) {
  return static_cast<std::int64_t>(value * scale + (value < 0.0 ? -0.5 : 0.5));
}

/// Writes units / 10^decimals without trailing zeros; `out` needs room for 24 characters.
/// @return one past the last character written
template <int decimals>
char* writeFixed(char* out, std::int64_t units) {
  constexpr std::uint64_t kScale = decimals == 5 ? 100000 : decimals == 4 ? 10000 : 1000;
  static_assert(decimals >= 3 && decimals <= 5, "the precisions of a program");
  if (units < 0) *out++ = '-';
  const std::uint64_t magnitude =
      units < 0 ? -static_cast<std::uint64_t>(units) : static_cast<std::uint64_t>(units);
  const std::uint64_t whole = magnitude / kScale;
  std::uint64_t fraction = magnitude % kScale;
  if (whole < 1000) {
    if (whole >= 100) *out++ = static_cast<char>('0' + whole / 100);
    if (whole >= 10) *out++ = static_cast<char>('0' + whole / 10 % 10);
    *out++ = static_cast<char>('0' + whole % 10);
  } else {
    out = std::to_chars(out, out + 20, whole).ptr;
  }
  if (fraction == 0) return out;
  *out = '.';
  char* last = out;
  for (int i = decimals; i > 0; --i) {
    const char digit = static_cast<char>('0' + fraction % 10);
    fraction /= 10;
    out[i] = digit;
    if (digit != '0' && last == out) last = out + i;
  }
  return last + 1;
}

}  // namespace lamina
