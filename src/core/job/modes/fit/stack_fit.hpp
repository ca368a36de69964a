// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "job/modes/fit/machine_fit.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/slicing/volumetric/head_room.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The room of a head while layers grow.
struct GrownRoom {
  const HeadRoom& room;
  const std::vector<double>& growth_mm;  ///< growth deposited up to and including each layer
};

/// Completes the plan of a stack that was grown with room for the head: tool axes are settled (`settleAxes`),
/// travels led over the part (`leadTravels`), and, where the machine can turn the tool axis and
/// `clearance.need` asks for it, all is fitted to the machine (`fitToMachine`).
/// @throws as `fitToMachine`
MachineFit fitGrown(Toolpath planned, const GrownRoom& grown, const PlanningRequest& request,
                    Progress& progress);

/// A stack as the machine can run it, and what was changed for this, one sentence for each change.
struct StackFit {
  Toolpath toolpath;
  std::vector<std::string> notes;
};

/// Fits a stack of layers to a machine that can turn the tool axis, if its program would be refused
/// otherwise. Some layers are tried first (`hopelessLayers`). Then tool axes are settled (`settleAxes`) if
/// joints turn too far, and raised (`raiseToolAxes`) if the machine runs into something or a joint is beyond
/// its limits as the tool axis leans, each only if fewer places remain that the machine cannot run; raising
/// ends before a round after which more places remain. The remaining places are cut (`fitToMachine`), unless
/// more would have to be left out than may be. A stack that is not refused, or is refused nevertheless, is
/// returned as it was planned.
/// @param standing_mm  highest z of solid material on the bed before the first layer [part frame]
/// @param progress     stages "joints" and "clearance"
/// @throws Unreachable if some layers alone show that no fit makes the machine run the stack: with the first
///   place, and how much of the beads leads to such places
/// @throws as `fitToMachine`
StackFit fitStack(Toolpath planned, double standing_mm, const PlanningRequest& request, Progress& progress);

/// A sentence on what a fit has left out, and where the nozzle turns off its bead.
std::string noteOnFit(const MachineFit& fit, double deposited_mm3);

}  // namespace lamina
