// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Chooses where the perimeters of one layer start. Progressive: from the leftmost point of the loop,
/// `perimeters.seam_step` farther for each layer below and each perimeter outside. Random: anywhere, by seed,
/// layer and island.
class LoopSeam {
 public:
  explicit LoopSeam(const InfillRequest& request);

  /// Position of the start of a loop, along it from its first point, in [0, its length) [mm].
  /// @param level  number of perimeters outside the loop
  double startOn(const Polygon& loop, std::size_t level);

 private:
  PerimeterSeam placement_;
  double step_;
  double layer_;
  Random random_;
};

/// The loop as a run that starts at a position and ends a gap before it. The run is closed if the gap is 0,
/// or if the loop is shorter than two gaps.
/// @param start_mm  along the loop from its first point, in [0, its length)
FillPath openedLoop(const Polygon& loop, double start_mm, double gap_mm);

}  // namespace lamina
