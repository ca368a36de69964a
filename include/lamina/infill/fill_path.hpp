// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// One run of a fill in the plane of the layer [mm].
struct FillPath {
  Polyline points;
  bool is_closed = false;
  PathRole role = PathRole::Infill;
  Deposit deposit = Deposit::Bead;
  /// Plan width that the bead fills on the way to each point, as `Path::bead` counts them; empty if it is the
  /// pitch everywhere. A width of 0 deposits nothing.
  std::vector<double> width_mm;
};

/// Where the run ends: its first point if it is closed.
const Point2& lastPoint(const FillPath& path);

/// The same run the other way round.
FillPath reversed(FillPath path);

}  // namespace lamina
