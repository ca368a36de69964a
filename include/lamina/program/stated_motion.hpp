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
  double feed_mm_s = 0.0;  ///< of a straight move
};

/// Moves that lead to the part, away from it, or from one of its waypoints to the next by way of elsewhere,
/// in the order in which they are run.
struct StatedPassage {
  /// Index in `StatedMotion::lines` of the waypoint that they lead to; the number of waypoints for what comes
  /// after the last.
  std::size_t before = 0;
  std::vector<StatedWay> ways;
  double feed_mm_s = 0.0;  ///< of the move from the last of them to that waypoint
};

/// A file of a program, and from which waypoint on its lines state the motion.
struct StatedFile {
  std::string name;
  std::size_t first = 0;  ///< index in `StatedMotion::lines`
};

/// The motion that a program commands of a machine or robot, with joint values as the program states them
/// instead of planned ones.
struct StatedMotion {
  Toolpath toolpath;  ///< in coordinates of the bed; each line that moves is a waypoint
  JointPath joints;   ///< at the waypoints; faults are those of waypoints without joints
  /// Numbers of the lines that state the waypoints, 1 based; as many as `joints.at`.
  std::vector<std::size_t> lines;
  std::vector<StatedFile>
      files;  ///< whose lines these are, in the order they are run; empty if only one can be
  StatedMove between = StatedMove::Joints;
  std::vector<StatedPassage> passages;  ///< ascending
};

/// A way beside the part, to the waypoint that is added next or behind the last.
inline void addWay(StatedMotion& motion, StatedWay way) {
  const std::size_t before = motion.lines.size();
  if (motion.passages.empty() || motion.passages.back().before != before)
    motion.passages.push_back({before, {}});
  motion.passages.back().ways.push_back(std::move(way));
}

/// The move to the waypoint that is added next has that feed; of note where it comes from beside the part.
inline void comeToPart(StatedMotion& motion, double feed_mm_s) {
  if (!motion.passages.empty() && motion.passages.back().before == motion.lines.size())
    motion.passages.back().feed_mm_s = feed_mm_s;
}

/// The waypoints added from here on are stated by the lines of that file.
inline void goOnInFile(StatedMotion& motion, const std::string& name) {
  if (motion.files.empty() || motion.files.back().name != name)
    motion.files.push_back({name, motion.lines.size()});
}

}  // namespace lamina
