// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "program/listed_paths.hpp"

namespace lamina {

/// A path as moves of a robot: one that takes the pose it starts in, where the path before ends in another,
/// and then its motions.
struct RobotPath : ListedPath {
  bool is_turned = false;     ///< begins with a move of its own
  bool switches_on = false;   ///< the process starts before its first motion
  bool switches_off = false;  ///< the process stops after its last motion

  bool deposits() const { return path->role != PathRole::Travel; }
  std::size_t turnCount() const { return is_turned ? 1 : 0; }
  std::size_t moveCount() const { return path->motionCount() + turnCount(); }
};

/// Whether a program's moves turn the tool.
enum class ToolTurns : std::uint8_t { None, Any };

/// All paths of a program. Depositing paths that meet in one pose are one run: the process goes on between
/// them.
/// @throws InvalidInput naming layer, path and waypoint: drops, a path of less than two waypoints, a position
///   that is not within 100 m, a feed, orientation or bead that is no such thing; if there is no path
std::vector<RobotPath> robotPaths(const Toolpath& toolpath, ToolTurns turns);

/// Waits of the toolpath between a move and what follows it [s]: those before the next motion of its path,
/// or, after its last one, those behind it and before the next path, if that begins without a move of its
/// own. After the last move of all, those at the toolpath's end too.
double dwellAfter(const Toolpath& toolpath, const std::vector<RobotPath>& paths, std::size_t path,
                  std::size_t move);

/// Paths that a split should not come between: travels up to a run, and the run.
struct RobotStretch {
  std::size_t begin = 0;  ///< path
  std::size_t end = 0;
  std::size_t points = 0;
};

std::vector<RobotStretch> robotStretches(const std::vector<RobotPath>& paths);

}  // namespace lamina
