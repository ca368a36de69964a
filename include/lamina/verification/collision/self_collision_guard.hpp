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

/// Keeps links that are two driven rotary joints apart, as forearm and head of an arm, out of each other.
///
/// Which values of the two joints bring them together is tabulated once in cells of 2 deg: a cell is banned
/// unless the links are clear of each other all over it, so that up to about 2 deg beside a collision are
/// banned too. Meshes are looked at by their hulls; a cell whose hulls meet is banned if the meshes do in its
/// middle, and `checkJointClearance` sees what is beside it. Asking takes no more than a look into the
/// tables. Links that are further apart, the part, and links that linear joints move are left to
/// `checkJointClearance`.
class SelfCollisionGuard final : public JointGuard {
 public:
  /// Nothing given is needed afterwards.
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
