// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/planning/runs/run_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Lets closed runs start elsewhere from layer to layer, so that starts do not stand above each other. A run
/// that is one closed path starts, in layer i, at the share frac(first + 0.618034 i) of its length from where
/// it was planned to (golden), or frac(first + i / 2) (opposite). Travels lead to the new starts, turned as
/// the nozzle is there. Runs that follow others without a travel, and paths with events amid them, stay.
/// @return how many start elsewhere
std::size_t spreadStarts(Toolpath& toolpath, const StartSettings& settings);

/// Lets closed runs go on over their start by `overlap_mm`. There the bead grows from nothing and, the second
/// time, fades to nothing, in 16 steps each, so that both together are the bead everywhere. Of runs that are
/// one closed path.
/// @return how many
/// @throws InvalidInput naming layer and path where the overlap is as long as the run
std::size_t overlapEnds(Toolpath& toolpath, const LeadSettings& settings);

/// Leads of a toolpath.
struct LeadCount {
  std::size_t added = 0;
  std::size_t shortened = 0;  ///< of those added, for want of room
  std::size_t left_out = 0;   ///< with less room than `least_mm`
};

/// What is added at the ends of runs.
struct EndCount {
  LeadCount leads;
  std::size_t entries = 0;
  std::size_t without_tangent =
      0;  ///< of the entries: along the tool axis, as there is no room along the run
};

/// Adds a lead before and after each run of the part: a travel at the run's feed, or a path of role Prime
/// where it lays a bead. It goes to the side with more room, and outside of a closed run where both have the
/// same: no nearer to other beads of the layer than beads are to each other. None that would lie on its own
/// bead along more than half of its way. A loop is smaller where there is less room, and keeps off its own
/// path but for where it touches that.
///
/// Lets the tool come to each run, or its lead, from `distance_mm` away, and leave it as far, straight and at
/// a feed of its own: by travels of their own. These, and leads that lay nothing, are retracted where the
/// travel beside them is.
///
/// Travels before and after lead to the ends of these. Runs that follow another path without a travel get
/// none.
EndCount addEnds(Toolpath& toolpath, const LeadSettings& lead, const EntrySettings& entry);

/// Lets the tip swing across the beads of the part, by waypoints of its own: whole half waves, of closed
/// paths whole waves, each path for itself, about its line. Left is that of the way, seen against the jet.
/// The volume along the line stays, and of open paths the ends. A path shorter than a quarter of a wave
/// stays.
/// @param limits  by which the machine can swing
/// @return how many paths are woven
/// @throws InvalidInput naming layer, path and values: a swing wider than the bead, or one that takes more
///   acceleration than the machine has; an event amid a path
std::size_t weave(Toolpath& toolpath, const WeaveSettings& settings, const MotionLimits& limits);

/// States process values on all that lays beads. At the ends of runs they rise and fall in steps of an eighth
/// of the way: each motion has the value of its middle. `from_bead` is the speed of a wire that brings the
/// bead's volume, section times feed over the wire's section. Once feeds are final.
/// @throws InvalidConfig as `statedLevels`
void stateLevels(Toolpath& toolpath, const LevelSettings& settings);

}  // namespace lamina
