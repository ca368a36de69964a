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

/// Keeps two links with two driven rotary joints between them, such as forearm and head of an arm, out of
/// each other.
///
/// Tables in cells of 2 deg hold the values of the two joints at which the links collide. They are made once.
/// A cell is banned unless the links are clear of each other all over it, so that up to about 2 deg beside a
/// collision are banned too. Meshes are tested by their hulls. A cell whose hulls meet is banned if the
/// meshes meet in its middle; `checkJointClearance` finds collisions beside that. A query takes no more than
/// a look into the tables. Links that are further apart, the part, and links that linear joints move are left
/// to `checkJointClearance`.
class SelfCollisionGuard final : public JointGuard {
 public:
  /// The arguments are not needed after construction.
  /// @param bodies  of the kinematic model's own description
  SelfCollisionGuard(const KinematicModel& model, const LinkBodies& bodies);
  ~SelfCollisionGuard() override;
  SelfCollisionGuard(const SelfCollisionGuard&) = delete;
  SelfCollisionGuard& operator=(const SelfCollisionGuard&) = delete;

  bool allows(const JointValues& values) const override;

  /// "link 'nozzle' would be in link 'link_4'": all links that hang together with the colliding ones.
  std::string hindrance(const JointValues& values) const override;

 private:
  std::vector<CollisionTable> tables_;
};

}  // namespace lamina
