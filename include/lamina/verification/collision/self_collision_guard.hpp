// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/kinematics/joint_path/joint_guard.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"

namespace lamina {

class CollisionTable;

/// Forbids joint values at which two links collide that have one or two driven rotary joints between them,
/// such as forearm and head of an arm, or its first link and a fence.
///
/// Tables with cells of 2 deg in these joints state where the links collide; they are computed once, so
/// that a query is a look-up. A cell is forbidden unless the links are free of collision everywhere in it, so
/// that values up to about 2 deg beside a collision are forbidden, too. Meshes are tested by their convex
/// hulls; if the hulls collide, the cell is forbidden only if the meshes collide at its middle. Collisions
/// elsewhere in such a cell are left to `checkJointClearance`, as are links with more joints between them,
/// links moved by linear joints, and the part.
class SelfCollisionGuard final : public JointGuard {
 public:
  /// The arguments need not outlive the call.
  /// @param bodies  from the kinematic model's own description
  SelfCollisionGuard(const KinematicModel& model, const LinkBodies& bodies);
  ~SelfCollisionGuard() override;
  SelfCollisionGuard(const SelfCollisionGuard&) = delete;
  SelfCollisionGuard& operator=(const SelfCollisionGuard&) = delete;

  bool allows(const JointValues& values) const override;

  /// The reason why joint values are forbidden, with the names of all links that are rigidly connected to the
  /// colliding ones: "link 'nozzle' would be in link 'link_4'".
  std::string hindrance(const JointValues& values) const override;

 private:
  std::vector<CollisionTable> tables_;
};

}  // namespace lamina
