// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/checked_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/model/link_motion.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "verification/collision/solid.hpp"

namespace lamina {
namespace {

constexpr std::size_t kSampledPoses = 200;
constexpr double kBuiltShare = 0.95;

using PosesOfLinks = std::map<std::string, Eigen::Isometry3d>;

/// Solid pieces of two links.
struct SolidPieces {
  std::vector<std::pair<Solid, const LinkBody*>> one;
  std::vector<std::pair<Solid, const LinkBody*>> other;
};

bool meetAt(const SolidPieces& pieces, const PosesOfLinks& links) {
  const auto poseIn = [&links](const LinkBody& body) { return links.at(body.link) * body.link_from_body; };
  for (const auto& [solid, body] : pieces.one)
    for (const auto& [other_solid, other] : pieces.other)
      if (solid.meets(other_solid, poseIn(*other), poseIn(*body))) return true;
  return false;
}

JointValues valuesNearestToZero(const KinematicModel& model) {
  JointValues values(static_cast<Eigen::Index>(model.joints().size()));
  for (Eigen::Index j = 0; j < values.size(); ++j) {
    const DrivenJoint& joint = model.joints()[static_cast<std::size_t>(j)];
    values[j] = std::clamp(0.0, joint.low, joint.high);
  }
  return values;
}

/// Of all values of the joints, turns of at most half a revolution.
JointValues drawnValues(const KinematicModel& model, Random& random) {
  JointValues values(static_cast<Eigen::Index>(model.joints().size()));
  for (Eigen::Index j = 0; j < values.size(); ++j) {
    const DrivenJoint& joint = model.joints()[static_cast<std::size_t>(j)];
    const bool is_rotary = joint.kind == JointKind::Rotary;
    const double low = is_rotary ? std::max(joint.low, -M_PI) : joint.low;
    const double high = is_rotary ? std::min(joint.high, M_PI) : joint.high;
    values[j] = low < high ? random.uniform(low, high) : joint.low;
  }
  return values;
}

/// Nothing where the legs of a platform cannot be closed.
std::optional<PosesOfLinks> posesAt(const KinematicModel& model, const JointValues& values) {
  try {
    return model.bedFromLinks(values);
  } catch (const Unreachable&) {
    return std::nullopt;
  }
}

std::vector<PosesOfLinks> sampledPoses(const KinematicModel& model) {
  Random random(1);
  std::vector<PosesOfLinks> poses;
  poses.reserve(kSampledPoses);
  for (std::size_t i = 0; i < kSampledPoses; ++i)
    if (auto drawn = posesAt(model, drawnValues(model, random))) poses.push_back(std::move(*drawn));
  return poses;
}

/// Those of links that are checked against each other, by the names of the links.
std::map<std::pair<std::string, std::string>, SolidPieces> collidingPieces(const LinkBodies& bodies) {
  std::map<std::pair<std::string, std::string>, SolidPieces> found;
  for (const auto& [a, b] : bodies.pairs)
    for (const LinkBody& one : bodies.groups[a].bodies)
      for (const LinkBody& other : bodies.groups[b].bodies)
        if (!areUnchecked(bodies, one.link, other.link)) found[{one.link, other.link}] = {};
  for (auto& [links, pieces] : found)
    for (const RigidGroup& group : bodies.groups)
      for (const LinkBody& body : group.bodies) {
        if (body.link == links.first) pieces.one.emplace_back(Solid(body.shape), &body);
        if (body.link == links.second) pieces.other.emplace_back(Solid(body.shape), &body);
      }
  return found;
}

/// Whether a link is on the way from the root to another.
bool carries(const urdf::ModelInterface& machine, const std::string& link, const std::string& other) {
  for (auto at = machine.getLink(other); at; at = at->getParent())
    if (at->name == link) return true;
  return false;
}

/// Whether a link is fixed to the root beside what moves, as beds and fences are: it is no piece of a robot
/// that meets it wherever this goes, but stands in its way.
bool standsBeside(const LinkBodies& bodies, const urdf::ModelInterface& machine,
                  const std::pair<std::string, std::string>& links) {
  const std::vector<std::string>& fixed = bodies.groups.front().links;
  return std::find(fixed.begin(), fixed.end(), links.first) != fixed.end() &&
         !carries(machine, links.first, links.second);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> builtInLinks(const KinematicModel& model,
                                                              const LinkBodies& bodies) {
  std::vector<std::pair<std::string, std::string>> built;
  const std::optional<PosesOfLinks> at_zero = posesAt(model, valuesNearestToZero(model));
  if (!at_zero) return built;
  const auto machine = parseMachine(model.urdf());
  std::vector<PosesOfLinks> poses;
  for (const auto& [links, pieces] : collidingPieces(bodies)) {
    if (standsBeside(bodies, *machine, links) || !meetAt(pieces, *at_zero)) continue;
    if (poses.empty()) poses = sampledPoses(model);
    const auto meeting = std::count_if(poses.begin(), poses.end(),
                                       [&pieces = pieces](const auto& each) { return meetAt(pieces, each); });
    if (static_cast<double>(meeting) > kBuiltShare * static_cast<double>(poses.size()))
      built.push_back(links);
  }
  return built;
}

LinkBodies checkedBodies(const KinematicModel& model) {
  LinkBodies bodies = linkBodies(model.urdf());
  const auto built = builtInLinks(model, bodies);
  bodies.ignored.insert(bodies.ignored.end(), built.begin(), built.end());
  return bodies;
}

}  // namespace lamina
