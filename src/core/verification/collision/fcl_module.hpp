// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "lamina/kinematics/cartesian/machine_bodies.hpp"

namespace lamina {

/// A shape as FCL holds it.
class CollisionShape {
 public:
  virtual ~CollisionShape() = default;
};

/// What the module `fcl` offers: FCL stays out of commands that check no collisions. Poses are of the shapes
/// in one frame [mm].
struct FclModule {
  std::shared_ptr<const CollisionShape> (*shape)(const BodyShape& shape);
  bool (*meet)(const CollisionShape& a, const Eigen::Isometry3d& pose_a, const CollisionShape& b,
               const Eigen::Isometry3d& pose_b);
  bool (*meets_box)(const CollisionShape& shape, const Eigen::Isometry3d& pose, const Point3& size,
                    const Eigen::Isometry3d& box_pose);
};

}  // namespace lamina
