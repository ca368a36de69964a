// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// One run of the nozzle that fills an area, in the plane of the layer [mm].
struct FillPath {
  Polyline points;
  bool is_closed = false;
  PathRole role = PathRole::Infill;
  Deposit deposit = Deposit::Bead;
  /// Width of the strip that the bead fills on the motion to each point [mm], indexed as `Path::bead`; empty
  /// if it is the pitch everywhere. Where the width is 0, nothing is deposited.
  std::vector<double> width_mm;
};

/// The last point of the run; the first point if the run is closed.
const Point2& lastPoint(const FillPath& path);

/// The same run in the opposite direction.
FillPath reversed(FillPath path);

/// Appends runs to others.
void appendTo(std::vector<FillPath>& runs, std::vector<FillPath> more);

}  // namespace lamina
