// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lamina/geometry/polygon.hpp"

namespace lamina {

/// What a fill strategy is asked for.
struct InfillRequest {
  double spacing_mm = 0.4;  ///< between neighbouring lines, centre to centre
  double bead_width_mm = 0.4;
  double angle_rad = 0.0;  ///< of the raster, from x counter-clockwise
};

/// One run of a fill in the plane of the layer [mm].
struct FillPath {
  Polyline points;
  bool is_closed = false;
};

/// Fills regions with paths whose centre lines lie inside them. The regions are where centre lines may run:
/// whoever calls has already taken off half a bead. No region gives no path. The same regions give the same
/// paths.
using InfillStrategy =
    std::function<std::vector<FillPath>(const Regions& regions, const InfillRequest& request)>;

/// The strategy of that name.
/// @throws InvalidConfig if there is none, naming those there are
InfillStrategy infillStrategy(const std::string& name);

/// Names of all strategies, in alphabetical order.
std::vector<std::string> infillStrategyNames();

}  // namespace lamina
