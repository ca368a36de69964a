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
  std::size_t index = 0;  ///< index of the move among the part's moves
};

/// A move of an approach or a retract.
struct RapidWay {
  std::size_t before = 0;             ///< number of moves of the part before it
  std::optional<RapidJoints> joints;  ///< of a MoveAbsJ
  RapidMove move;                     ///< of any other
  std::size_t line = 0;
};

/// A program in the order in which it is run.
struct RapidRunning {
  Toolpath toolpath;
  std::vector<RapidStation> stations;  ///< the start of each path, and the end of each of its motions
  std::vector<RapidWay> ways;          ///< in the order in which they are run
};

/// Motion that a program states; see `readRapidMotion`.
StatedMotion rapidMotionOf(const RapidSource& source, RapidRunning running, const KinematicModel& arm);

}  // namespace lamina
