// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

/// Refuses a length that is not positive and finite.
/// @throws InvalidConfig naming the key
inline void requirePositive(const std::string& key, double length_mm) {
  if (length_mm > 0.0 && std::isfinite(length_mm)) return;
  throw InvalidConfig(key + " is " + numberText(length_mm) + " mm; must be positive");
}

}  // namespace lamina
