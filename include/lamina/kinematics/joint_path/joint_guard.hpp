// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Forbids joint values within the limits of a kinematic model, such as those at which links collide with
/// each other. Guards are immutable; all calls may be made from several threads.
class JointGuard {
 public:
  virtual ~JointGuard() = default;

  virtual bool allows(const JointValues& values) const = 0;

  /// Why the values are not allowed, for people; empty if they are.
  virtual std::string hindrance(const JointValues& values) const = 0;
};

/// Allows everything.
class NoGuard final : public JointGuard {
 public:
  bool allows(const JointValues&) const override { return true; }
  std::string hindrance(const JointValues&) const override { return {}; }
};

/// A kinematic model and its guard; both must outlive the value.
struct GuardedModel {
  const KinematicModel& model;
  const JointGuard& guard;
};

}  // namespace lamina
