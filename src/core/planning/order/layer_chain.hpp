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
/// lower, the path begins with a bead that rises from that end to the start. There is no such bead if it
/// would begin more than a twentieth of its width outside the section of its layer. With one such loop per
/// layer the part is one path without travel. Elsewhere, and between the runs of a layer, there are travels.
///
/// The direction of a loop is chosen so that the loop ends within the section of the layer above, and near
/// that layer's loop. Loops shorter than two pitches stay closed. Travels between layers are not made here.
/// Distances are measured in space, so that layers need not be level.
/// @param sections  of the layers, where they lie; empty for lifted ones, which are not looked at
/// @param anchor    place where the first layer starts [mm]
/// @param travel    makes the travels between the runs of a layer
void chainLayers(std::vector<ToolpathLayer>& layers, const std::vector<Layer>& sections,
                 const PlanSettings& settings, const Point3& anchor, const TravelMaker& travel);

}  // namespace lamina
