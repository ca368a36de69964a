// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// One wall: loops where there is room for them, and beads as wide as the place where there is not.
struct Wall {
  Regions centre_lines;        ///< of the loops
  std::vector<FillPath> thin;  ///< beads along the middle of narrow places, open or closed
};

/// The walls of an area and the area inside them.
struct Walls {
  /// Wall 0 (outermost), 1, and so on. Centre lines lie half a bead inside the area, and a pitch farther for
  /// each further wall. Where less than two beads have room, a wall has thin beads instead. There are fewer
  /// walls than in the settings where the area is too narrow.
  std::vector<Wall> walls;
  /// Area of the infill.
  Regions infill;
  /// Beads along the middle of places too narrow for lines of infill.
  std::vector<FillPath> narrow_infill;
  /// Area of places that are thinner than the narrowest bead, `walls.narrowest` pitches [mm²].
  double unprinted_mm2 = 0.0;
};

/// An area of a fill, divided by its width.
struct FittedArea {
  Regions wide;                  ///< where lines of the fill fit
  std::vector<FillPath> narrow;  ///< beads along the middle of places too narrow for lines
};

/// Divides an area that a solid fill covers from border to border.
FittedArea fitted(Regions area, const PlanSettings& settings, double pitch_mm);

/// Takes narrow gaps out of the area of a sparse fill: places between walls that are narrower than a bead.
/// The fill would leave them empty over the whole height, and the walls would not hold together. Without
/// walls there are no gaps.
/// @param inside      area inside the walls, extended into the walls by the overlap
/// @param sparse      part of `inside` that the fill covers; may be narrow beside other fills
/// @param overlap_mm  of both areas with the walls
FittedArea withoutNarrowGaps(const Regions& inside, Regions sparse, double overlap_mm,
                             const PlanSettings& settings, double pitch_mm);

/// Plans the walls of an area.
/// @param material  the area [mm]
/// @param pitch_mm  distance of neighbouring beads
/// @param contact   `Fitted` is for a solid infill only
Walls makeWalls(const Regions& material, const PlanSettings& settings, double pitch_mm, WallContact contact);

}  // namespace lamina
