// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "lamina/kinematics/cartesian/machine_bodies.hpp"
#include "verification/collision/deposited_boxes.hpp"
#include "verification/collision/extents.hpp"

namespace lamina {

class CollisionShape;

/// A shape that contains everything within the margin [mm] of another: for a cone a cylinder, for a mesh its
/// convex hull.
BodyShape grown(const BodyShape& shape, double margin);

/// A shape that FCL tests for collisions.
class Solid {
 public:
  explicit Solid(const BodyShape& shape);

  /// Extents of the shape at a pose.
  /// @param normal  normal of the layers, of unit length [frame of the pose]
  Extents extentsAt(const Eigen::Isometry3d& pose, const Point3& normal) const;

  /// Bounding box of the shape at a pose, along the axes of the shape's own frame.
  TurnedBox boxAt(const Eigen::Isometry3d& pose) const;

  bool meets(const DepositedBox& box, const Eigen::Isometry3d& pose) const;
  bool meets(const Solid& other, const Eigen::Isometry3d& other_pose, const Eigen::Isometry3d& pose) const;

  /// Least distance to another [mm], 0 where they meet.
  double distanceTo(const Solid& other, const Eigen::Isometry3d& other_pose,
                    const Eigen::Isometry3d& pose) const;

 private:
  BodyShape shape_;
  Box3 bounds_;  ///< bounding box of the shape in its own frame
  std::shared_ptr<const CollisionShape> geometry_;
};

}  // namespace lamina
