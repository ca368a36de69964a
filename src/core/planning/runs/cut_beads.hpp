// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <set>

#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_index.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {

/// Waypoints at which a machine cannot run a toolpath unchanged.
struct HinderedWaypoints {
  std::set<WaypointIndex> shut;  ///< of beads: the head has no room there
  std::set<WaypointIndex> off;   ///< of beads: the motion to the waypoint cannot be deposited
  /// Of beads: on the motion to the waypoint a joint turns farther than a bead allows.
  std::set<WaypointIndex> turning;
  std::set<WaypointIndex> low;  ///< first waypoints of travels that pass too close to deposited material

  bool isEmpty() const { return shut.empty() && off.empty() && turning.empty() && low.empty(); }
};

/// Distance by which a travel leaves the bead along the tool axis [mm]; 0 if it goes straight.
double rise(const Path& travel);

/// A toolpath after cutting, and what was cut.
struct CutBeads {
  Toolpath toolpath;
  double left_out_mm3 = 0.0;
  std::size_t turns = 0;  ///< number of pieces before which the nozzle leaves the bead to turn
};

/// Leaves out the motions to and from shut waypoints, motions that cannot be deposited, and remaining pieces
/// shorter than their bead is wide. Before a motion to a turning waypoint, the nozzle leaves the bead, takes
/// the orientation of that waypoint, and returns. Closed paths that are cut become open ones.
///
/// Travels between remaining paths are kept, low ones with three times their rise; all other travels are made
/// anew. Events before a motion that is left out are dropped.
/// @param hindered  of beads and travels; drops are unchanged
/// @param off_mm    distance by which the nozzle leaves a bead to turn, and least rise of a low travel
CutBeads cutBeads(Toolpath toolpath, const HinderedWaypoints& hindered, const TravelMaker& travel,
                  double off_mm);

}  // namespace lamina
