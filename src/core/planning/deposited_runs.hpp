// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/planner.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/order/ordering.hpp"

namespace lamina {

/// Area of the regions that no path after the first `before` paths enters [mm²].
double areaMissed(const Regions& regions, const std::vector<Path>& paths, std::size_t before);

/// The ends of runs.
std::vector<RunEnds> endsOf(const std::vector<FillPath>& runs);
/// Runs in the order and directions in which they are deposited: as given, or reordered for short travels.
/// @param from  place from which the nozzle comes [mm]
std::vector<FillPath> inOrder(std::vector<FillPath> runs, RunOrder order, const Point2& from);
/// The ends of closed runs: both are the first point.
std::vector<RunEnds> endsOf(const std::vector<Polygon>& loops);

/// The ends of the runs of infill among the paths after the first `before` ones.
std::vector<RunEnds> fillsSince(const std::vector<Path>& paths, std::size_t before);

/// The refilling of voids by the paths after the first `before` ones.
Refilling refillingSince(const std::vector<Path>& paths, std::size_t before);

}  // namespace lamina
