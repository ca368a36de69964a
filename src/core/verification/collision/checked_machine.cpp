// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/checked_machine.hpp"

#include <mutex>
#include <optional>

#include "lamina/verification/collision/checked_bodies.hpp"
#include "lamina/verification/collision/self_collision_guard.hpp"

namespace lamina {

struct CheckedMachine::Made {
  std::once_flag has_bodies;
  std::once_flag has_guard;
  LinkBodies bodies;
  std::optional<SelfCollisionGuard> guard;
};

CheckedMachine::CheckedMachine(const KinematicModel& model)
    : model_(model), made_(std::make_unique<Made>()) {}

CheckedMachine::~CheckedMachine() = default;

const LinkBodies& CheckedMachine::bodies() const {
  std::call_once(made_->has_bodies, [this] { made_->bodies = checkedBodies(model_); });
  return made_->bodies;
}

const JointGuard& CheckedMachine::guard() const {
  std::call_once(made_->has_guard, [this] { made_->guard.emplace(model_, bodies()); });
  return *made_->guard;
}

}  // namespace lamina
