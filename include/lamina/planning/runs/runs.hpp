// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/planning/runs/bead_run_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Moves the starts of closed runs from layer to layer, so that they do not stand above each other. The start
/// of a run that is one closed path moves along the run, in layer i by a share of its length: frac(first +
/// 0.618034 i) (golden) or frac(first + i / 2) (opposite). Travels lead to the new starts, with the
/// orientation of the nozzle there. Runs that follow others without a travel, and paths with events within
/// them, keep their starts.
/// @return number of runs whose start was moved
std::size_t spreadStarts(Toolpath& toolpath, const StartSettings& settings);

/// Extends runs that are one closed path over their own start by `overlap_mm`. On the overlap the bead grows
/// from nothing in the first pass and fades to nothing in the second one, in 16 steps each. Both passes
/// together deposit the planned bead everywhere. With a negative overlap such runs end that distance before
/// their start, if they are at least ten times as long.
/// @return number of runs that were extended or shortened
/// @throws InvalidInput naming layer and path if the overlap is as long as the run
std::size_t overlapEnds(Toolpath& toolpath, const LeadSettings& settings);

/// Numbers of leads of a toolpath.
struct LeadCount {
  std::size_t added = 0;
  std::size_t shortened = 0;  ///< number of the added leads that were shortened for lack of room
  std::size_t left_out = 0;   ///< number of leads for which there is less room than `least_mm`
};

/// Numbers of what is added at the ends of runs.
struct EndCount {
  LeadCount leads;
  std::size_t entries = 0;
  std::size_t without_tangent = 0;  ///< number of entries along the tool axis for lack of room along the run
};

/// Adds a lead before and after each run of the part: a travel at the run's feed, or a path of role Prime if
/// it deposits a bead. A lead goes to the side with more room; if both sides have the same, it goes to the
/// outside of a closed run. From other beads of the layer it keeps the distance of neighbouring beads. A lead
/// that would overlap the bead of its own run along more than half of the lead's length is left out. A loop
/// is smaller where there is less room. It keeps off its own path except at the point of contact.
///
/// Adds an entry and an exit to each run, or to its lead: separate straight travels of length `distance_mm`,
/// at a feed of their own. Entries, exits and leads that deposit nothing are retracted if the adjacent travel
/// is.
///
/// The travels before and after the run then end and start at the added motions. Runs that follow another
/// path without a travel get neither leads nor entries.
EndCount addEnds(Toolpath& toolpath, const LeadSettings& lead, const EntrySettings& entry);

/// Lets the tip swing across the beads of the part, by additional waypoints. Each path is woven by itself,
/// about its own line, in a whole number of half waves, or of whole waves if it is closed. Left is left of
/// the direction of travel, seen against the tool axis. The volume along the line and the ends of open paths
/// do not change. A path shorter than a quarter of a wave is not woven.
/// @param limits  of the machine, which bound the swing
/// @return number of paths that are woven
/// @throws InvalidInput naming layer, path and values if the swing is wider than the bead, or needs more
///   acceleration than the machine has; if an event stands amid a path
std::size_t weave(Toolpath& toolpath, const WeaveSettings& settings, const MotionLimits& limits);

/// States process values on all paths that deposit beads. At the ends of runs they rise and fall in eight
/// steps over the length of the settings; each motion has the value at its middle. With `from_bead` the value
/// supplies the bead's volume: for wire, the bead's section times the feed, divided by the wire's section;
/// for powder, the mass flow by density and efficiency. To be called once feeds are final.
/// @throws InvalidConfig as `statedLevels`
void stateLevels(Toolpath& toolpath, const LevelSettings& settings);

}  // namespace lamina
