// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "planning/skins/layer_cover.hpp"

namespace lamina {

/// Sizes that decide where skins end [mm].
struct SkinMeasures {
  double narrowest_mm = 0.0;      ///< what is narrower is no skin
  double anchor_mm = 0.0;         ///< by which a skin grows into the infill
  double least_infill_mm2 = 0.0;  ///< smaller areas of infill become skin
  double thinnest_mm = 0.0;  ///< what is narrower than a skin but not than this gets a bead; 0: nothing does
  double bead_mm = 0.0;      ///< by half of which the area of such a bead is wider than what is seen
};

/// From the outline to the border of what the walls leave [mm].
double wallThickness(const PlanSettings& settings, double pitch_mm);

/// As the settings say, at that pitch between neighbouring beads.
SkinMeasures skinMeasures(const PlanSettings& settings, double pitch_mm);

/// An area within walls, shared out. The parts do not overlap, and together are the area.
struct SkinAreas {
  Regions bottom_skin;  ///< seen from below
  Regions skin;         ///< solid and hidden
  Regions top_skin;     ///< seen from above; from both sides, this one
  Regions thickening;   ///< too narrow for a skin, beside walls that lean: for one bead more
  Regions sparse;       ///< for the infill
};

/// A place is skin if one of the layers that skins count does not cover it.
/// @param inside  walls, of one layer
SkinAreas skinAreas(const Regions& inside, const LayerCover& cover, const SkinMeasures& measures);

/// Whether a region is smaller than that.
bool hasSmall(const Regions& regions, double least_mm2);

}  // namespace lamina
