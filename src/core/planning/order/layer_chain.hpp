// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {

/// Opens the closed infill of each layer at the place nearest to where the nozzle comes from, leaves the last
/// nine tenths of a pitch out, and joins the layers: where the layer below ended within a pitch, seen along
/// the tool axis, and no farther than two layers below, a bead rises from there to the start, as the first
/// motion of the layer's path. With one such joined loop per layer the part becomes one path without travel.
/// Elsewhere, and between the runs of a layer, travels stay.
///
/// The direction of a joined loop is chosen so that it ends near the joined loop above. Joined loops shorter
/// than two pitches stay closed. Travels between layers are not made here. Distances are measured in space,
/// so that layers need not be level [Guacheta2021, algorithm 3-3].
/// @param anchor  where the first layer starts [mm]
/// @param travel  makes those between the runs of a layer
void chainLayers(std::vector<ToolpathLayer>& layers, const PlanSettings& settings, const Point3& anchor,
                 const TravelMaker& travel);

}  // namespace lamina
