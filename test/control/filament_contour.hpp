// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina::test {

constexpr Bead kFilament{0.4, 0.2};

inline double areaOfFilament() { return 0.2 * 0.2 + M_PI * 0.1 * 0.1; }

/// Depth of a stadium as high as planned that holds a share of the planned section; a layer deep beside it.
inline double depthOf(double share, double across_mm) {
  const double width = kFilament.width_mm - (1.0 - share) * areaOfFilament() / kFilament.height_mm;
  const double from_flat = std::abs(across_mm) - 0.5 * (width - kFilament.height_mm);
  if (from_flat <= 0.0) return 0.0;
  return from_flat < 0.1 ? 0.1 - std::sqrt(0.01 - from_flat * from_flat) : kFilament.height_mm;
}

}  // namespace lamina::test
