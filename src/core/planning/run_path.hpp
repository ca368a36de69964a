// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/fill_path.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The run with short motions merged, as at the ends of lines in a narrow place. Motions shorter than a
/// bead's width that lie within a twentieth of it from a straight line become one motion with their volume.
/// Others stay, and so do runs of one width.
/// @param bead_mm  width of a nominal bead
FillPath withoutShortMotions(FillPath run, double bead_mm);

/// The runs without those that fill no more than a dot inside the part: reached by a travel, they deposit
/// less than the nozzle oozes on the way. Sparse infill shorter than two bead widths, and skins, inner walls
/// and gap fills shorter than one. What is seen stays, and so do drops.
/// @param bead_mm  width of a nominal bead
std::vector<FillPath> withoutDots(std::vector<FillPath> runs, double bead_mm);

/// The beads of a run by the widths of the strips that they fill [mm], one per waypoint.
/// @param area_per_width  cross-section of a bead over that width [mm]: the layer height, unless
/// `bead.pitch_mm` is set
AlongPath<Bead> beadsOf(const std::vector<double>& width_mm, double area_per_width, double height_mm);

/// The beads of a run by its role.
/// @param nominal   bead of the layer
/// @param pitch_mm  distance of neighbouring nominal beads
AlongPath<Bead> beadsAlong(const FillPath& run, const PlanSettings& settings, const Bead& nominal,
                           double pitch_mm);

/// The path with a factor on the cross-section of its beads.
Path withFlow(Path path, double factor);

/// The layer without a factor that was applied to all beads of the part.
ToolpathLayer withoutFlow(ToolpathLayer layer, double factor);

/// The path along a run at the height of the nozzle tip [mm], at that feed [mm/s].
Path pathAlong(const FillPath& run, AlongPath<Bead> bead, double z_mm, double feed_mm_s);

}  // namespace lamina
