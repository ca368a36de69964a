// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Chooses where the perimeters of one layer start. Progressive: `perimeters.seam_step` farther along from
/// the leftmost point of the loop for each layer below and each perimeter outside. Random: anywhere, by
/// seed, layer and island.
class LoopSeam {
 public:
  explicit LoopSeam(const InfillRequest& request);

  /// Along the loop from its first point, within [0, its length) [mm].
  /// @param level  number of perimeters outside
  double startOn(const Polygon& loop, std::size_t level);

 private:
  PerimeterSeam placement_;
  double step_;
  double layer_;
  Random random_;
};

/// The loop from a place on, ending a gap short of it; closed if there is no gap, or if the loop is not at
/// least twice as long.
/// @param start_mm  along the loop from its first point, within [0, its length)
FillPath openedLoop(const Polygon& loop, double start_mm, double gap_mm);

}  // namespace lamina
