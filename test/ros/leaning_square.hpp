// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "conversions.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina::test {

/// Where the nozzle is to be.
struct PlayedWaypoint {
  Point3 tip;  ///< [mm, bed frame]
  Point3 tool_axis;
};

/// A toolpath for a machine.
struct PlayedSquare {
  MachineToolpath placed;
  std::vector<PlayedWaypoint> waypoints;  ///< in the order of the motion
};

/// Off the middle of all joints, where no wrist is straight and no tool axis upright.
inline JointValues offTheMiddle(const KinematicModel& model) {
  constexpr double kEndless = 1e5;  // mm, rad
  JointValues values(static_cast<Eigen::Index>(model.joints().size()));
  for (std::size_t j = 0; j < model.joints().size(); ++j) {
    const DrivenJoint& joint = model.joints()[j];
    const bool is_endless = joint.high - joint.low > kEndless;
    values[static_cast<Eigen::Index>(j)] = is_endless ? 100.0 : joint.low + 0.6 * (joint.high - joint.low);
  }
  return values;
}

inline bool canTilt(const KinematicModel& model) {
  std::size_t rotary = 0;
  for (const DrivenJoint& joint : model.joints()) rotary += joint.kind == JointKind::Rotary ? 1 : 0;
  return rotary >= 2;
}

/// A square on two layers about where the nozzle is with its joints off the middle, the tool axis leaning in
/// turn.
inline PlayedSquare squareOn(const KinematicModel& model) {
  constexpr double kLean = 0.15;  // rad
  const Eigen::Isometry3d nozzle = model.bedFromNozzle(offTheMiddle(model));
  PlayedSquare made;
  made.placed.machine = model.name();
  made.placed.bed_from_part = Eigen::Translation3d(nozzle.translation());
  made.placed.toolpath.part_name = "square";
  Eigen::Quaterniond upright(nozzle.linear());
  for (const double z : {0.0, 0.5}) {
    Path travel;
    travel.role = PathRole::Travel;
    travel.points = {{0, 0, z - 0.5}, {0, 0, z}};
    Path wall;
    wall.role = PathRole::OuterWall;
    wall.is_closed = true;
    wall.points = {{0, 0, z}, {8, 0, z}, {8, 6, z}, {0, 6, z}};
    // Ends where it has not been before.
    if (z > 0.0)
      wall.points = {{0, 0, z}, {8, 0, z}, {8, 6, z}, {0, 6, z}, {-2, 6, z}}, wall.is_closed = false;
    wall.bead = Bead{0.8, 0.5};
    for (Path* path : {&travel, &wall}) {
      path->feed_mm_s = 40.0;
      std::vector<Eigen::Quaterniond> held;
      for (std::size_t i = 0; i < path->points.size(); ++i) {
        const double lean = canTilt(model) && path == &wall ? (i % 2 == 0 ? 0.0 : kLean) : 0.0;
        held.emplace_back(upright * Eigen::AngleAxisd(lean, Point3(1, 1, 0).normalized()));
      }
      path->orientation = AlongPath<Eigen::Quaterniond>(held);
      for (std::size_t i = 0; i <= path->motionCount(); ++i) {
        const std::size_t at = i % path->points.size();
        made.waypoints.push_back({made.placed.bed_from_part * path->points[at], held[at] * Point3::UnitZ()});
      }
    }
    made.placed.toolpath.layers.push_back({z, 0.5, {travel, wall}});
  }
  made.placed.id = toolpathId(made.placed.toolpath);
  return made;
}

}  // namespace lamina::test
