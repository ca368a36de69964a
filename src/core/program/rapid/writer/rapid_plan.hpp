// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/program/rapid/rapid_settings.hpp"
#include "program/robot/writer/robot_paths.hpp"

namespace lamina {

using RapidPath = RobotPath;

/// A place in a program, before a move: `move` may be the path's number of moves nowhere but at the end.
struct RapidPlace {
  std::size_t path = 0;
  std::size_t move = 0;
};

/// What goes into one procedure.
struct RapidChunk {
  RapidPlace begin;
  RapidPlace end;
  std::size_t points = 0;
};

/// All paths of a program, and how they are shared out to procedures.
struct RapidPlan {
  std::vector<RapidPath> paths;
  std::vector<RapidChunk> chunks;
};

/// Depositing paths that meet in one pose are one run: the process goes on between them.
/// @throws InvalidInput naming layer, path and waypoint: see `RapidProgram`
/// @throws InvalidConfig if modules are loaded in turn and a run is longer than one of them
RapidPlan planRapid(const Toolpath& toolpath, const RapidSettings& settings);

}  // namespace lamina
