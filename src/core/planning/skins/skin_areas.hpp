// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/skins/layer_cover.hpp"

namespace lamina {

/// Sizes that decide where skins end [mm].
struct SkinMeasures {
  double narrowest_mm = 0.0;      ///< narrower places are no skin
  double anchor_mm = 0.0;         ///< by which a skin extends into the infill
  double least_infill_mm2 = 0.0;  ///< smaller areas of infill become skin
  double thinnest_mm = 0.0;  ///< places narrower than a skin, but at least this wide, get a bead; 0: none do
  double bead_mm = 0.0;      ///< the area of such a bead extends beyond the visible area by half of this
};

/// Thickness of the walls: distance from the outline to the area inside them [mm].
double wallThickness(const PlanSettings& settings, double pitch_mm);

/// The measures by the settings, for the given pitch of neighbouring beads.
SkinMeasures skinMeasures(const PlanSettings& settings, double pitch_mm);

/// An area within walls, divided into parts that do not overlap and together are the area.
struct SkinAreas {
  Regions bottom_skin;  ///< visible from below
  Regions skin;         ///< solid and hidden
  Regions top_skin;     ///< visible from above, or from both sides
  Regions thickening;   ///< too narrow for a skin, beside leaning walls; gets one more bead
  Regions sparse;       ///< for the infill
};

/// Divides an area. A place is skin if one of the layers that skins consider does not cover it.
/// @param inside  area within the walls of one layer
SkinAreas skinAreas(const Regions& inside, const LayerCover& cover, const SkinMeasures& measures);

/// Whether any region has less than this area.
bool hasSmall(const Regions& regions, double least_mm2);

}  // namespace lamina
