// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/clear_approach.hpp"

#include <optional>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/verification/collision/checked_machine.hpp"
#include "lamina/verification/collision/joint_clearance.hpp"

namespace lamina {
namespace {

constexpr int kDoublings = 6;
constexpr double kHighest = 1000.0;  // mm

/// What the way runs into first.
std::optional<Collision> firstCollision(const Approach& approach, const CheckedMachine& machine,
                                        const ClearanceSettings& settings, Progress& progress) {
  Path travel;
  travel.role = PathRole::Travel;
  JointPath path;
  for (const JointValues& values : approach.stations) {
    path.at.push_back({0, 0, travel.points.size()});
    path.values.push_back(values);
    travel.points.emplace_back(machine.model().bedFromNozzle(values).translation());
  }
  Toolpath toolpath;
  toolpath.layers.push_back({0.0, 0.0, {travel}});
  const JointClearanceReport report = checkJointClearance(
      {toolpath, Eigen::Isometry3d::Identity(), machine.model(), path}, machine.bodies(), settings, progress);
  if (report.collisions.empty()) return std::nullopt;
  return report.collisions.front();
}

std::string textOf(const Collision& collision) {
  return "link '" + collision.link + "' runs into " +
         (collision.obstacle == Obstacle::Machine ? "link '" + collision.other + "'" : "the bed");
}

}  // namespace

Approach clearApproach(const JointValues& from, const JointValues& to, const KinematicModel& model,
                       const ApproachDemands& demands, Progress& progress) {
  ApproachSettings way = demands.way;
  if (!(way.lift_mm <= kHighest))
    throw InvalidConfig("approach.lift_mm is " + numberText(way.lift_mm) + " mm; expected at most " +
                        numberText(kHighest) + " mm");
  const CheckedMachine machine(model);
  std::optional<Collision> first;
  for (int i = 0; i <= kDoublings && way.lift_mm <= kHighest; ++i, way.lift_mm *= 2.0) {
    Approach tried = approach(from, to, model, way, demands.timing);
    const std::optional<Collision> collision = firstCollision(tried, machine, demands.clearance, progress);
    if (!collision) return tried;
    if (!first) first = collision;
  }
  throw Unreachable("on the way from where the machine stands to the start of the job " + textOf(*first) +
                    ", and with higher lifts too; " + model.name() + " must be moved clear before");
}

}  // namespace lamina
