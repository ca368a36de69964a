// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/program/rapid/rapid_settings.hpp"
#include "program/robot/writer/robot_paths.hpp"

namespace lamina {

using RapidPath = RobotPath;

/// A position in a program, before a move. Only at the end of the program does `move` equal the path's number
/// of moves.
struct RapidPlace {
  std::size_t path = 0;
  std::size_t move = 0;
};

/// Range of moves that one procedure holds.
struct RapidChunk {
  RapidPlace begin;
  RapidPlace end;
  std::size_t points = 0;
};

/// All paths of a program, and their division into procedures.
struct RapidPlan {
  std::vector<RapidPath> paths;
  std::vector<RapidChunk> chunks;
};

/// Plans the procedures of a program. Depositing paths that meet in one pose form one run, during which the
/// process continues.
/// @throws InvalidInput naming layer, path and waypoint: see `RapidProgram`
/// @throws InvalidConfig if modules are loaded in turn and a run is longer than one of them
RapidPlan planRapid(const Toolpath& toolpath, const RapidSettings& settings);

}  // namespace lamina
