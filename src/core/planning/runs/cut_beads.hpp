// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <set>

#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_index.hpp"
#include "planning/travel/travel.hpp"

namespace lamina {

/// What a machine cannot run of a toolpath as it is.
struct HinderedWaypoints {
  std::set<WaypointIndex> shut;     ///< of beads: the head has no room there
  std::set<WaypointIndex> off;      ///< of beads: the motion to them cannot be deposited
  std::set<WaypointIndex> turning;  ///< of beads: on the way to them a joint turns farther than a bead allows
  std::set<WaypointIndex> low;      ///< first ones of travels that are too near to what is deposited

  bool isEmpty() const { return shut.empty() && off.empty() && turning.empty() && low.empty(); }
};

/// By how much a travel leaves the bead along the tool axis [mm]; 0 if it goes straight.
double rise(const Path& travel);

/// A toolpath that was cut.
struct CutBeads {
  Toolpath toolpath;
  double left_out_mm3 = 0.0;
  std::size_t turns = 0;  ///< pieces before which the nozzle turns off the bead
};

/// Leaves out the motions to and from shut waypoints, those that cannot be deposited, and what is shorter
/// than its bead is wide between them. Before a motion to a turning waypoint the nozzle leaves the bead,
/// takes the orientation it has at that waypoint, and comes back. Closed paths that are cut become open ones.
///
/// Travels between paths that stay are kept, those that are low at three times their rise; the others are
/// made anew. Events before a motion that is left out are left out.
/// @param hindered  of beads; drops stay as they are
/// @param off_mm    by which the nozzle leaves a bead to turn, and a low travel rises at least
CutBeads cutBeads(Toolpath toolpath, const HinderedWaypoints& hindered, const TravelMaker& travel,
                  double off_mm);

}  // namespace lamina
