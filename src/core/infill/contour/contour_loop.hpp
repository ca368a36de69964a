// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A closed centre line that fills its part of a region.
struct ContourLoop {
  Polygon points;
  std::vector<double> width_mm;  ///< plan width on the way to each point
  std::size_t node = 0;          ///< of the tree it belongs to
};

}  // namespace lamina
