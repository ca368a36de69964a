// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/program/stated_motion.hpp"

namespace lamina {

/// First waypoint of a layer.
/// @throws InvalidInput if the motion has no such layer
WaypointIndex waypointOfLayer(const StatedMotion& motion, std::size_t layer);

/// First waypoint of the first layer whose top is at a height or above [mm, frame of the layers].
/// @throws InvalidInput if all layers are below
WaypointIndex waypointAtHeight(const StatedMotion& motion, double height_mm);

/// A line of a program.
struct StatedLine {
  std::size_t number = 0;  ///< number of the line in its file, from 1
  /// File of the line, with or without folder and suffix, in upper or lower case; empty for a program of one
  /// file.
  std::string file = {};
};

/// The waypoint at which the move of a line starts; for a line without a move, the start of the next move.
/// @throws InvalidInput if neither the line nor a later one moves; if the program has several files and none
///   is named; if the named file is not a file of the program, or states no move
WaypointIndex waypointAtLine(const StatedMotion& motion, const StatedLine& line);

/// The rest of a motion from a waypoint on. A path that is cut there is open, and begins with that waypoint;
/// travels before the first path that deposits are left out.
/// @throws InvalidInput if nothing is deposited from there on
StatedMotion remainingMotion(const StatedMotion& motion, const WaypointIndex& from);

}  // namespace lamina
