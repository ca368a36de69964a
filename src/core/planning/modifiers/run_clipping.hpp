// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// The places at which the straight line between two points meets the outlines, as shares of its length
/// between 0 and 1, ascending. The cost is proportional to the number of edges.
std::vector<double> crossings(const Point2& from, const Point2& to, const std::vector<Polygon>& borders);

/// The pieces of a run that lie in the regions. A closed run that lies in them as a whole stays closed; any
/// other closed run is not cut at its start. Pieces shorter than 1e-3 mm are left out.
std::vector<FillPath> clipped(const FillPath& run, const Regions& area);

/// The pieces of several runs, in their order.
std::vector<FillPath> clipped(const std::vector<FillPath>& runs, const Regions& area);

}  // namespace lamina
