// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Rule for the area enclosed by outlines that may run in either direction and may cross.
enum class FillRule : std::uint8_t {
  NonZero,  ///< points with a winding number other than 0
  EvenOdd,  ///< points from which a ray to the outside crosses outlines an odd number of times
};

/// The area that outlines enclose by a rule, rounded to the grid of `unite`.
Regions enclosed(const std::vector<Polygon>& outlines, FillRule rule);

}  // namespace lamina
