// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "program/listed_paths.hpp"

namespace lamina {

/// A path as moves of a robot. If the path before ends in another pose, a move to the path's first pose
/// precedes its motions.
struct RobotPath : ListedPath {
  bool is_turned = false;     ///< whether it begins with such a move
  bool switches_on = false;   ///< whether the process starts before its first motion
  bool switches_off = false;  ///< whether the process stops after its last motion

  bool deposits() const { return path->role != PathRole::Travel; }
  std::size_t turnCount() const { return is_turned ? 1 : 0; }
  std::size_t moveCount() const { return path->motionCount() + turnCount(); }
};

/// Whether a program's moves may change the orientation of the tool.
enum class ToolTurns : std::uint8_t { None, Any };

/// All paths of a program. Depositing paths that meet in one pose form one run, during which the process
/// continues.
/// @throws InvalidInput naming layer, path and waypoint: for drops, a path of fewer than two waypoints, a
///   position beyond 100 m, or an invalid feed, orientation or bead; if there is no path
std::vector<RobotPath> robotPaths(const Toolpath& toolpath, ToolTurns turns);

/// Duration of the toolpath's waits after a move [s]: waits before the next motion of the path. After the
/// last move of a path: waits at its end, and waits before the next path unless that path begins with a move
/// of its own. After the last move of the program: waits at the toolpath's end too.
double dwellAfter(const Toolpath& toolpath, const std::vector<RobotPath>& paths, std::size_t path,
                  std::size_t move);

/// A range of paths that should stay in one file: a run, and the travels to it.
struct RobotStretch {
  std::size_t begin = 0;  ///< index of its first path
  std::size_t end = 0;
  std::size_t points = 0;
};

std::vector<RobotStretch> robotStretches(const std::vector<RobotPath>& paths);

}  // namespace lamina
