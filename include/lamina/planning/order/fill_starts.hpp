// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace lamina {

/// Starts and travels of a fill, compared with the least possible. Walls and perimeters do not count.
struct FillStarts {
  std::size_t runs = 0;
  /// Connected areas inside the walls with room for a bead: the least number of runs.
  std::size_t regions = 0;
  double travel_mm = 0.0;       ///< between runs of the same area
  double best_travel_mm = 0.0;  ///< the same travel in the order found by the optimiser, from the same start
};

FillStarts& operator+=(FillStarts& sum, const FillStarts& more);

}  // namespace lamina
