// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {

/// Opens the closed infill of each layer and chains the layers [Guacheta2021, algorithm 3-3].
///
/// A loop is opened at the place nearest to the nozzle, and its last nine tenths of a pitch are left out. If
/// the layer below ended within a pitch of that place, seen along the tool axis, and at most two layers
/// lower, a bead rises from there to the start as the first motion of the path, unless it would begin outside
/// the section of its layer by more than a twentieth of its width. With one such loop per layer
/// the part is one path without travel. Elsewhere, and between the runs of a layer, there are travels.
///
/// The direction of a loop is chosen so that it ends in the section above, and near its loop. Loops shorter
/// than two pitches stay closed. Travels between layers are not made here. Distances are measured in space,
/// so that layers need not be level.
/// @param sections  of the layers, where they lie; empty for lifted ones, which are not looked at
/// @param anchor    place where the first layer starts [mm]
/// @param travel    makes the travels between the runs of a layer
void chainLayers(std::vector<ToolpathLayer>& layers, const std::vector<Layer>& sections,
                 const PlanSettings& settings, const Point3& anchor, const TravelMaker& travel);

}  // namespace lamina
