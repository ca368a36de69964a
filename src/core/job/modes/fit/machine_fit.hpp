// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "job/modes/fit/plan_check.hpp"
#include "job/modes/travels_over_part.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath as far as a machine can run it.
struct MachineFit {
  Toolpath toolpath;  ///< its travels led
  TravelsOverPart travels;
  double left_out_mm3 = 0.0;
  std::size_t turns = 0;           ///< pieces before which the nozzle turns off the bead
  std::size_t hindered = 0;        ///< waypoints that the machine cannot run of what was planned
  std::size_t still_hindered = 0;  ///< the same of what is given back
};

/// Checks a toolpath as `checkRun` does and cuts the beads that the machine cannot lay (`cutBeads`), from
/// check to check: where it would run into something they are left out, and where a joint turns too far
/// beside a singularity they are deposited in pieces. After a cut only the layers that it changed are checked
/// again; once they are clear, everything is, and what is given back is as that check found it. No more is
/// left out than `volumetric.largest_left_out_percent`; what is hindered then stays for the check that
/// refuses it.
///
/// @param beads     its travels not led yet
/// @param progress  stages "joints" and "clearance"
/// @throws as `runOn` and `checkRun`
MachineFit fitToMachine(Toolpath beads, const PlanningRequest& request, const LeadTravels& lead,
                        Progress& progress);

}  // namespace lamina
