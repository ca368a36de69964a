// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath corrected for a process that feeds at a constant rate, as wire and powder do. The amount is
/// deposited by the time spent on each millimetre: the feed becomes the planned one times (1 + speed) / (1 +
/// amount). The shift moves the nozzle against its tool axis. Beads keep their planned sizes.
///
/// Motions are split where the amount changes by more than `split_change`; the time of each piece is exact. A
/// corrected closed path becomes an open one that ends at its start. Travels connect the shifted ends of the
/// paths beside them. Events before a path and behind it stay there. Paths and layers keep their numbers;
/// without maps the toolpath is unchanged.
///
/// @param maps  at most one per layer
/// @throws InvalidInput as `validate`; naming layer and path: of a path with drops or events amid it, or one
///   whose height differs from that of the path before without a travel between; if a map is of another
///   toolpath, or shifts the nozzle by more than its layer's height; if `split_change` is not positive
Toolpath correctedToolpath(const Toolpath& toolpath, const std::vector<CorrectionMap>& maps,
                           double split_change);

/// Refuses the toolpath read from a program if it is not the one that was planned. It may have further
/// waypoints between those of the latter, on the way.
/// @throws InvalidInput naming the first layer, path or waypoint that differs by more than `tolerance_mm`
void requireSamePaths(const Toolpath& read, const Toolpath& planned, double tolerance_mm);

}  // namespace lamina
