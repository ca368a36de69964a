// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath corrected for a process that feeds at a constant rate, such as wire or powder. There the amount
/// deposited depends on the time spent on each millimetre: the feed becomes the planned one over 1 + amount.
/// Speeds of a map apply to a feeder that is led. The map's amounts allow for them: here they change nothing.
/// The shift moves the nozzle against its tool axis. Beads keep their planned sizes.
///
/// Motions are split where the amount changes by more than `split_change`; the time that each piece
/// takes is exact. A corrected closed path becomes an open one that ends at its start. Travels are moved so
/// that they connect the shifted ends of the paths before and after. Events before the first or after the
/// last motion of a path stay there. Paths and layers keep their numbers; without corrections the toolpath is
/// unchanged.
///
/// @param maps  at most one per layer
/// @throws InvalidInput as `validate` of a map; if a map is of another toolpath, or shifts the nozzle by more
///   than its layer's height; naming layer and path, if a path to be corrected has drops or events between
///   its motions, or the nozzle would step from one path to the next without a travel between; if
///   `split_change` is not positive
Toolpath correctedToolpath(const Toolpath& toolpath, const std::vector<CorrectionMap>& maps,
                           double split_change);

/// Checks that the toolpath read from a program is the planned one. It may have further waypoints between the
/// planned ones, on the straight line.
/// @throws InvalidInput naming the first layer, path or waypoint that differs, with positions compared to
///   within `tolerance_mm`
void requireSamePaths(const Toolpath& read, const Toolpath& planned, double tolerance_mm);

}  // namespace lamina
