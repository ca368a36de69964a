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

/// A waypoint of a program's toolpath, and the move that leads there.
struct RapidStation {
  WaypointIndex at;
  RapidMove move;
};

/// A program as it runs.
struct RapidRunning {
  Toolpath toolpath;
  std::vector<RapidStation> stations;  ///< where each path starts, and the end of each of its motions
  std::optional<RapidJoints> start;    ///< of the approach
};

/// See `readRapidMotion`.
StatedMotion rapidMotionOf(const RapidSource& source, RapidRunning running, const KinematicModel& arm);

}  // namespace lamina
