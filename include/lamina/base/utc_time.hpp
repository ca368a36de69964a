// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <string>

namespace lamina {

/// The time of day by the clock of the host [s since 1970, UTC]. It may jump; use `Clock` to measure
/// durations.
inline double utcNow() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// A time of day as text, by a format of `strftime` that gives at most 63 characters: with "%Y-%m-%d",
/// "2026-11-23".
/// @param utc_s  since 1970; fractions of a second are left out
inline std::string utcText(double utc_s, const char* format) {
  const auto seconds = static_cast<std::time_t>(std::floor(utc_s));
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), format, &parts);
  return text.data();
}

/// A time of day as files state it: "2026-11-23T12:00:00Z".
inline std::string utcText(double utc_s) { return utcText(utc_s, "%Y-%m-%dT%H:%M:%SZ"); }

}  // namespace lamina
