// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath corrected for a process whose source gives the same in the same time, as wire and powder that
/// run at a constant rate: 1 + amount lasts as much longer on each millimetre, so that the feed becomes
/// planned times (1 + speed) / (1 + amount). The nozzle moves back along its tool axis by the height. Beads
/// stay those that are aimed at.
///
/// Motions are split where the amount changes by more than `split_change`; the time of each piece is exact. A
/// closed path that is corrected becomes one that ends where it began. Travels lead from and to the heights
/// beside them. Paths and layers keep their numbers; without maps the toolpath is the same.
///
/// @param maps  one per layer at most
/// @throws InvalidInput as `validate`; naming layer and path: of a path with drops or events, or one whose
///   height differs from that of the path before without a travel between; if a map is of another toolpath,
///   or shifts the nozzle by more than its layer's height; if the change at which motions are split is not
///   positive
Toolpath correctedToolpath(const Toolpath& toolpath, const std::vector<CorrectionMap>& maps,
                           double split_change);

/// Refuses a toolpath as a program reads back that is not the one the maps are of.
/// @throws InvalidInput naming the first layer, path or waypoint that differs by more than `tolerance_mm`
void requireSamePaths(const Toolpath& read, const Toolpath& planned, double tolerance_mm);

}  // namespace lamina
