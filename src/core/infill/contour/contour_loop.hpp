// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A closed centre line, whose bead fills a strip of a region.
struct ContourLoop {
  Polygon points;
  std::vector<double> width_mm;  ///< plan width of the bead on the motion to each point
  std::size_t node = 0;          ///< index of its node in the contour tree
};

}  // namespace lamina
