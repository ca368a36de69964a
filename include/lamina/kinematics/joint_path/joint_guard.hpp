// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// What keeps a kinematic model from joint values that are within its limits, as links that would be in each
/// other. Values that never change; all calls may be made from several threads.
class JointGuard {
 public:
  virtual ~JointGuard() = default;

  virtual bool allows(const JointValues& values) const = 0;

  /// Why values that are not allowed are not, for people.
  virtual std::string hindrance(const JointValues& values) const = 0;
};

/// Allows everything.
class NoGuard final : public JointGuard {
 public:
  bool allows(const JointValues&) const override { return true; }
  std::string hindrance(const JointValues&) const override { return {}; }
};

/// A kinematic model and what keeps watch over it; both must outlive the value.
struct GuardedModel {
  const KinematicModel& model;
  const JointGuard& guard;
};

}  // namespace lamina
