// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/self_collision_guard.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "kinematics/model/link_motion.hpp"
#include "kinematics/model/link_tree.hpp"
#include "verification/collision/collision_table.hpp"

namespace lamina {
namespace {

std::optional<Eigen::Index> rotaryJoint(const std::vector<DrivenJoint>& joints, const std::string& name) {
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j].name == name && joints[j].kind == JointKind::Rotary) return static_cast<Eigen::Index>(j);
  return std::nullopt;
}

/// The groups that hang on the two joints between two groups, the first next to `near`; nothing if there are
/// more joints between them.
std::optional<std::array<const RigidGroup*, 2>> hangingBetween(const LinkBodies& bodies, std::size_t near,
                                                               std::size_t far) {
  const RigidGroup& a = bodies.groups[near];
  const RigidGroup& b = bodies.groups[far];
  const RigidGroup& between = bodies.groups[b.parent];
  if (b.joint.empty()) return std::nullopt;
  if (!between.joint.empty() && between.parent == near) return std::array{&between, &b};
  if (!a.joint.empty() && a.parent == b.parent) return std::array{&a, &b};
  return std::nullopt;
}

std::optional<JointedPair> jointedPair(const LinkBodies& bodies, std::size_t near, std::size_t far,
                                       const std::vector<DrivenJoint>& joints) {
  const auto hanging = hangingBetween(bodies, near, far);
  if (!hanging) return std::nullopt;
  JointedPair pair{&bodies.groups[near], &bodies.groups[far]};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto joint = rotaryJoint(joints, (*hanging)[i]->joint);
    if (!joint) return std::nullopt;
    pair.joints[i] = *joint;
    pair.axis_links[i] = (*hanging)[i]->links.front();
  }
  return pair;
}

}  // namespace

SelfCollisionGuard::SelfCollisionGuard(const KinematicModel& model, const LinkBodies& bodies) {
  const LinkTree tree(*parseMachine(model.urdf()));
  const std::vector<DrivenJoint>& joints = model.joints();
  for (const auto& [near, far] : bodies.pairs) {
    const auto pair = jointedPair(bodies, near, far, joints);
    if (!pair) continue;
    const auto nameOf = [&](std::size_t i) { return joints[static_cast<std::size_t>(pair->joints[i])].name; };
    // How two groups stand to each other is a matter of the joints between them alone.
    tables_.emplace_back(*pair, joints, [&](double first, double second) {
      return tree.rootFromLinks({{nameOf(0), first}, {nameOf(1), second}});
    });
  }
}

SelfCollisionGuard::~SelfCollisionGuard() = default;

bool SelfCollisionGuard::allows(const JointValues& values) const {
  return std::none_of(tables_.begin(), tables_.end(),
                      [&](const CollisionTable& table) { return table.isBanned(values); });
}

std::string SelfCollisionGuard::hindrance(const JointValues& values) const {
  const auto banned = std::find_if(tables_.begin(), tables_.end(),
                                   [&](const CollisionTable& table) { return table.isBanned(values); });
  return banned == tables_.end() ? std::string() : banned->text();
}

}  // namespace lamina
