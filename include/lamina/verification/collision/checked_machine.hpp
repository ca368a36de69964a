// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "lamina/kinematics/joint_path/joint_guard.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"

namespace lamina {

/// A machine or robot, with the solid pieces of its links (`checkedBodies`) and the guard against its own
/// links (`SelfCollisionGuard`), for planning and checking joint paths. With manufacturers' meshes both take
/// seconds to make. Each is made at its first use, once for any number of plans and checks. Calls may come
/// from several threads.
class CheckedMachine {
 public:
  /// @param model  must outlive this
  explicit CheckedMachine(const KinematicModel& model);
  ~CheckedMachine();
  CheckedMachine(const CheckedMachine&) = delete;
  CheckedMachine& operator=(const CheckedMachine&) = delete;

  const KinematicModel& model() const { return model_; }

  /// @throws InvalidConfig as `linkBodies`
  const LinkBodies& bodies() const;

  /// @throws InvalidConfig as `linkBodies`
  const JointGuard& guard() const;

 private:
  struct Made;

  const KinematicModel& model_;
  std::unique_ptr<Made> made_;
};

}  // namespace lamina
