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

/// Area [mm²] of those regions into which none of the paths goes that follow the first so many.
double areaMissed(const Regions& regions, const std::vector<Path>& paths, std::size_t before);

/// Where runs start and end.
std::vector<RunEnds> endsOf(const std::vector<FillPath>& runs);
/// Runs as they are laid, each in its direction: as given, or the shortest travels between them.
/// @param from  where the nozzle comes from [mm]
std::vector<FillPath> inOrder(std::vector<FillPath> runs, RunOrder order, const Point2& from);
/// Of closed runs both are the first point.
std::vector<RunEnds> endsOf(const std::vector<Polygon>& loops);

/// Ends of the runs of infill among the paths that follow the first so many.
std::vector<RunEnds> fillsSince(const std::vector<Path>& paths, std::size_t before);

/// What voids were refilled with: runs and material of the paths that follow the first so many.
Refilling refillingSince(const std::vector<Path>& paths, std::size_t before);

}  // namespace lamina
