// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Which places outlines enclose, whatever way they run and however they cross.
enum class FillRule : std::uint8_t {
  NonZero,  ///< those they wind round more often one way than the other
  EvenOdd,  ///< those from which one crosses an odd number of them on the way out
};

/// The area that outlines enclose, on the grid of `unite`.
/// @throws InvalidInput for points farther than 10 m from the origin
Regions enclosed(const std::vector<Polygon>& outlines, FillRule rule);

}  // namespace lamina
