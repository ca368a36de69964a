// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/fill_path.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The run with short motions merged, as at the ends of lines in a narrow place. Motions shorter than a bead
/// width that lie within a twentieth of that width from a straight line become one motion of the same volume.
/// Other motions, and runs of one width, are unchanged.
/// @param bead_mm  width of a nominal bead
FillPath withoutShortMotions(FillPath run, double bead_mm);

/// The runs without dots inside the part: runs that deposit less than the nozzle oozes on the travel to them.
/// Dots are sparse infill shorter than two bead widths, and skins, inner walls and gap fills shorter than
/// one. Visible runs and drops are kept.
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

/// The path along a run at the given height of the nozzle tip [mm] and feed [mm/s].
Path pathAlong(const FillPath& run, AlongPath<Bead> bead, double z_mm, double feed_mm_s);

}  // namespace lamina
