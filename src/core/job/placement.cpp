// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/placement.hpp"

namespace lamina {

Eigen::Isometry3d placePart(const Box3& part, const Point2& bed_centre, Placement placement) {
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  if (placement == Placement::AsIs || part.isEmpty()) return bed_from_part;
  const Point3 centre = part.centre();
  bed_from_part.translation() =
      Point3(bed_centre.x() - centre.x(), bed_centre.y() - centre.y(), -part.low.z());
  return bed_from_part;
}

}  // namespace lamina
