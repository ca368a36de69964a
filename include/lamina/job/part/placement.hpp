// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How a part is placed on the bed.
enum class Placement {
  Centre,  ///< middle of its bounding box over the middle of the bed, bottom on the bed
  AsIs,    ///< coordinates of the file are used as coordinates of the bed
};

/// Pose bed_from_part [mm] of a part with this bounding box, without rotation.
Eigen::Isometry3d placePart(const Box3& part, const Point2& bed_centre, Placement placement);

/// Pose bed_from_part [mm] of a part in a build space: over its middle, without rotation. Along an endless
/// edge, as that of a belt, the part begins where the belt begins: no corner of its box lies before the low
/// end.
Eigen::Isometry3d placePart(const Box3& part, const BuildSpace& space, Placement placement);

/// Pose bed_from_part [mm] of a toolpath whose part is not known: what it deposits lies over the middle of
/// the space, with the undersides of the lowest beads on the bed. The identity if it deposits nothing.
Eigen::Isometry3d placeDeposition(const Toolpath& toolpath, const BuildSpace& space);

}  // namespace lamina
