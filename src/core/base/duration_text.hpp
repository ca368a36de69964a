// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "base/decimals.hpp"

namespace lamina {

/// A duration for messages, rounded to tenths of a second: "2.5 s".
inline std::string nearestTenths(double duration_s) { return decimalText(duration_s, 1) + " s"; }

/// A duration for messages, rounded down to tenths of a second.
inline std::string fullTenths(double duration_s) {
  std::string text = decimalText(duration_s, 6);
  text.erase(text.find('.') + 2);
  return text + " s";
}

/// A duration for messages, rounded down to whole seconds: "12 s".
inline std::string wholeSeconds(double duration_s) {
  return std::to_string(static_cast<int>(duration_s)) + " s";
}

}  // namespace lamina
