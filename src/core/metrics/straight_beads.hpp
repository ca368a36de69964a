// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/metrics/metrics_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A straight piece of a bead, as long as the bead is straight; for a drop a point.
struct StraightBead {
  Point3 start = Point3::Zero();  ///< start of the line that the piece follows [mm, part frame]
  Point3 end = Point3::Zero();
  Point3 tool_axis = -Point3::UnitZ();  ///< unit vector at the end [part frame]
  Bead bead;
  double plan_width_mm = 0.0;  ///< plan width seen along the tool axis; of a drop its diameter
  /// Directions of the pieces to which this one is joined, of unit length; zero if there is none.
  Point3 before = Point3::Zero();
  Point3 after = Point3::Zero();
};

/// All deposited pieces of a toolpath, in order. Motions that continue straight with the same bead are one
/// piece. Pieces are joined if nothing lies between them, also across paths. Motions shorter than 1e-9 mm are
/// left out.
std::vector<StraightBead> straightBeads(const Toolpath& toolpath, BeadLine line);

}  // namespace lamina
