// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "lamina/kinematics/cartesian/machine_bodies.hpp"

namespace lamina {

/// A shape in FCL's representation.
class CollisionShape {
 public:
  virtual ~CollisionShape() = default;
};

/// Functions of the module `fcl`, which keeps FCL out of commands that check no collisions. Both poses are in
/// the same frame [mm].
struct FclModule {
  std::shared_ptr<const CollisionShape> (*shape)(const BodyShape& shape);
  bool (*meet)(const CollisionShape& a, const Eigen::Isometry3d& pose_a, const CollisionShape& b,
               const Eigen::Isometry3d& pose_b);
  /// Least distance [mm], 0 where they meet.
  double (*apart)(const CollisionShape& a, const Eigen::Isometry3d& pose_a, const CollisionShape& b,
                  const Eigen::Isometry3d& pose_b);
  bool (*meets_box)(const CollisionShape& shape, const Eigen::Isometry3d& pose, const Point3& size,
                    const Eigen::Isometry3d& box_pose);
};

}  // namespace lamina
