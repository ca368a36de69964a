// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/metrics/metrics_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A straight piece of a bead, as long as it stays straight; of a drop a point.
struct StraightBead {
  Point3 start = Point3::Zero();  ///< of the line that is followed [mm, part frame]
  Point3 end = Point3::Zero();
  Point3 tool_axis = -Point3::UnitZ();  ///< unit vector at the end [part frame]
  Bead bead;
  double plan_width_mm = 0.0;  ///< that it fills seen along the tool axis; of a drop its diameter
  /// Unit vectors of the pieces that this one is joined to; zero if there is none.
  Point3 before = Point3::Zero();
  Point3 after = Point3::Zero();
};

/// All that a toolpath lays, in order. Motions that go on straight with the same bead are one piece; pieces
/// are joined where nothing lies between them, also from path to path. Motions shorter than 1e-9 mm are none.
std::vector<StraightBead> straightBeads(const Toolpath& toolpath, BeadLine line);

}  // namespace lamina
