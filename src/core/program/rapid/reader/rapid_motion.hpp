// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/stated_motion.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "program/rapid/reader/rapid_source.hpp"

namespace lamina {

/// A waypoint of a program's toolpath, and the move that ends there.
struct RapidStation {
  WaypointIndex at;
  RapidMove move;
};

/// A program in the order in which it is run.
struct RapidRunning {
  Toolpath toolpath;
  std::vector<RapidStation> stations;  ///< the start of each path, and the end of each of its motions
  std::optional<RapidJoints> start;    ///< joints of the approach
};

/// Motion that a program states; see `readRapidMotion`.
StatedMotion rapidMotionOf(const RapidSource& source, RapidRunning running, const KinematicModel& arm);

}  // namespace lamina
