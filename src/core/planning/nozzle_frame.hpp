// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The orientation of the nozzle with its tool axis against a normal of unit length: `nozzleDown()` turned by
/// the shortest rotation from +z to the normal, so that it does not spin. For +z it is exactly
/// `nozzleDown()`. It is continuous except at -z, where the frames of nozzle and part are aligned.
inline Eigen::Quaterniond nozzleAgainst(const Point3& normal) {
  // The turn from +z to n is (1 + n.z, -n.y, n.x, 0) but for its length; times (0, 1, 0, 0).
  const Eigen::Quaterniond turned(normal.y(), 1.0 + normal.z(), 0.0, -normal.x());
  return turned.norm() > 1e-9 ? turned.normalized() : Eigen::Quaterniond::Identity();
}

/// Direction against the tool axis.
inline Point3 againstToolAxis(const Eigen::Quaterniond& part_from_nozzle) {
  return part_from_nozzle * Point3(0.0, 0.0, -1.0);
}

}  // namespace lamina
