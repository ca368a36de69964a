// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/fill_path.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A run without motions shorter than a bead is wide where these lie within a twentieth of a bead of a
/// straight one, with the volume they had: the ends of lines in a narrow place. Others stay, as do runs of
/// one width.
/// @param bead_mm  width of a nominal bead
FillPath withoutShortMotions(FillPath run, double bead_mm);

/// The beads of a run by its plan widths [mm], one per waypoint.
/// @param area_per_width  cross-section of a bead by its plan width [mm]; the layer height, unless
///                        `bead.pitch_mm` says that beads are no stadiums
AlongPath<Bead> beadsOf(const std::vector<double>& width_mm, double area_per_width, double height_mm);

/// The beads of a run by what it is of the part.
/// @param nominal   in that layer
/// @param pitch_mm  at which nominal beads lie side by side
AlongPath<Bead> beadsAlong(const FillPath& run, const PlanSettings& settings, const Bead& nominal,
                           double pitch_mm);

/// A path with that factor on the cross-section of its beads.
Path withFlow(Path path, double factor);

/// A layer as it was before all of the part in it got that factor.
ToolpathLayer withoutFlow(ToolpathLayer layer, double factor);

/// The path along a run at the height of the nozzle tip [mm], at that feed [mm/s].
Path pathAlong(const FillPath& run, AlongPath<Bead> bead, double z_mm, double feed_mm_s);

}  // namespace lamina
