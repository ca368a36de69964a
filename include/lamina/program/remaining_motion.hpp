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
  std::size_t number = 0;  ///< from 1
  /// The file it is of, with or without folder and suffix, in any case; empty for that of a program of one
  /// file.
  std::string file = {};
};

/// The waypoint from which the move of a line sets out; of a line without a move, that of the next one.
/// @throws InvalidInput if no move comes from there on; if the program has several files and none is named;
/// if
///   the one that is named is none of them, or states no move
WaypointIndex waypointAtLine(const StatedMotion& motion, const StatedLine& line);

/// The rest of a motion from a waypoint on. A path that is cut there is open, and begins with that waypoint;
/// travels before the first path that deposits are left out.
/// @throws InvalidInput if nothing is deposited from there on
StatedMotion remainingMotion(const StatedMotion& motion, const WaypointIndex& from);

}  // namespace lamina
