// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What moves steadily from one stated waypoint to the next.
enum class StatedMove : std::uint8_t {
  Joints,  ///< the joints
  Nozzle,  ///< the nozzle: its tip on a straight line, its orientation at constant angular speed
};

/// A move that a program states beside the part, without material.
struct StatedWay {
  JointValues to;  ///< joints at its end; empty where there are none
  StatedMove by = StatedMove::Nozzle;
  std::size_t line = 0;    ///< 1 based
  std::string fault;       ///< why there are no joints; empty where there are
  double feed_mm_s = 0.0;  ///< feed of a straight move
};

/// Moves to the part, away from the part, or beside the part between two of its waypoints, in the order in
/// which they are run.
struct StatedPassage {
  /// Index in `StatedMotion::lines` of the waypoint to which the moves lead; the number of waypoints for
  /// moves after the last waypoint.
  std::size_t before = 0;
  std::vector<StatedWay> ways;
  double feed_mm_s = 0.0;  ///< feed of the move from the last of these to that waypoint
};

/// A file of a program, and from which waypoint on its lines state the motion.
struct StatedFile {
  std::string name;
  std::size_t first = 0;  ///< index in `StatedMotion::lines`
};

/// The motion that a program commands of a machine or robot, with joint values as the program states them
/// instead of planned ones.
struct StatedMotion {
  Toolpath toolpath;  ///< toolpath in coordinates of the bed; each line that moves is a waypoint
  JointPath joints;   ///< joint values at the waypoints; faults are those of waypoints without joints
  /// Numbers of the lines that state the waypoints, 1 based; as many as `joints.at`.
  std::vector<std::size_t> lines;
  /// Files of these lines, in the order in which they are run; empty if there can be only one.
  std::vector<StatedFile> files;
  StatedMove between = StatedMove::Joints;
  std::vector<StatedPassage> passages;  ///< ascending
};

/// Adds a move beside the part: to the waypoint that is added next, or after the last waypoint.
inline void addWay(StatedMotion& motion, StatedWay way) {
  const std::size_t before = motion.lines.size();
  if (motion.passages.empty() || motion.passages.back().before != before)
    motion.passages.push_back({before, {}});
  motion.passages.back().ways.push_back(std::move(way));
}

/// Sets the feed of the move to the waypoint that is added next, if this move comes from beside the part.
inline void comeToPart(StatedMotion& motion, double feed_mm_s) {
  if (!motion.passages.empty() && motion.passages.back().before == motion.lines.size())
    motion.passages.back().feed_mm_s = feed_mm_s;
}

/// Assigns the waypoints that are added from now on to the lines of a file.
inline void goOnInFile(StatedMotion& motion, const std::string& name) {
  if (motion.files.empty() || motion.files.back().name != name)
    motion.files.push_back({name, motion.lines.size()});
}

}  // namespace lamina
