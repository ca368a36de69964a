// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>

#include "job/modes/fit/plan_check.hpp"
#include "job/modes/travels_over_part.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Height of what stands on an empty bed.
constexpr double kNothingStands = -std::numeric_limits<double>::infinity();

/// A toolpath cut to what a machine can run, and what was cut.
struct MachineFit {
  Toolpath toolpath;  ///< with its travels planned
  TravelsOverPart travels;
  double left_out_mm3 = 0.0;
  std::size_t turns = 0;     ///< number of bead pieces before which the nozzle leaves the bead to turn
  std::size_t hindered = 0;  ///< number of waypoints of the original toolpath that the machine cannot run
  std::size_t still_hindered = 0;  ///< number of waypoints of `toolpath` that the machine cannot run
};

/// Checks a toolpath as `checkRun` does and cuts the beads that the machine cannot deposit (`cutBeads`),
/// repeatedly: a bead is left out where the machine would collide, and deposited in pieces where a joint
/// would turn too far beside a singularity. After each cut only the changed layers are checked again; once
/// these pass, the whole toolpath is checked, and the result is that of this check. At most
/// `volumetric.largest_left_out_percent` is left out; waypoints that are still hindered remain in the
/// toolpath, and the later check refuses them.
///
/// @param beads        toolpath whose travels are not planned yet
/// @param progress     stages "joints" and "clearance"
/// @param standing_mm  highest z of solid material on the bed before the first layer [part frame]
/// @throws as `runOn` and `checkRun`
MachineFit fitToMachine(Toolpath beads, const PlanningRequest& request, const LeadTravels& lead,
                        Progress& progress, double standing_mm = kNothingStands);

}  // namespace lamina
