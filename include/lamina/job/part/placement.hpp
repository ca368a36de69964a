// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Where a part stands on the bed.
enum class Placement {
  Centre,  ///< middle of its box over the middle of the bed, bottom on the bed
  AsIs,    ///< coordinates of the file are coordinates of the bed
};

/// bed_from_part [mm] of a part with this box. Turns nothing.
Eigen::Isometry3d placePart(const Box3& part, const Point2& bed_centre, Placement placement);

/// The same in a build space: over its middle. Along an endless edge, a belt, the part begins where the belt
/// does: every point of its box is at the low end or beyond it.
Eigen::Isometry3d placePart(const Box3& part, const BuildSpace& space, Placement placement);

/// The same of a toolpath whose part is not known: its deposition stands over the middle of the space, and
/// the undersides of its lowest beads on the bed. A toolpath that deposits nothing stays where it is.
Eigen::Isometry3d placeDeposition(const Toolpath& toolpath, const BuildSpace& space);

}  // namespace lamina
