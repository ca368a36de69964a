// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "job/modes/fit/plan_check.hpp"
#include "job/raised_axes.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What a machine cannot run of some layers of a stack, as planned and however far their tool axes are
/// raised.
struct HopelessLayers {
  MachineCheck check;            ///< of the beads of these layers alone, without singular places
  bool is_out_of_reach = false;  ///< whether `check` holds faults alone that nothing mends
  std::size_t layers = 0;        ///< number of them
  double hindered_mm3 = 0.0;     ///< of beads to and from waypoints that the machine cannot run
  double most_mm3 = 0.0;         ///< of beads that may be left out of the whole stack
};

/// The faults of the planned stack that neither raising nor leaving out beads mends.
using UnmendableFaults = std::function<std::vector<Finding>(const MachineCheck&)>;

/// Volume of the beads to and from waypoints that a machine cannot run, other than for a singularity [mm³]:
/// what would have to be left out.
double hinderedVolume(const MachineCheck& check, const Toolpath& beads);

/// Tries some layers of a stack, spread over its height, before all of it is checked: as planned, and with
/// their tool axes raised as those of the whole would be (`raiseToolAxes`). The round that hinders the least
/// of the beads counts. Singular places do not count: there the nozzle may leave the bead to turn. If these
/// layers let expect that more of the stack is hindered than may be left out of it
/// (`volumetric.largest_left_out_percent`), the layers nearest to those hindered are tried, up to 24 in all.
/// @param unmendable  faults for which the stack is refused if any is found in the first layers as planned
/// @return what was found once that much is hindered in the layers tried, or a fault that nothing mends: no
///   fit of the whole can mend it; nothing otherwise
/// @throws as `raiseToolAxes`
std::optional<HopelessLayers> hopelessLayers(const Toolpath& planned, const RaisingSite& site,
                                             const PlanCheck& check, const UnmendableFaults& unmendable);

}  // namespace lamina
