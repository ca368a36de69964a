// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job/modes/part_planning.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// Plans a part by its mode, or the one that `auto` chooses, and then orients the nozzle as the settings say.
/// Notes go to the summary.
/// @throws as `planByMode`; InvalidInput if the nozzle would be held too far off the layers' normal
Toolpath planOriented(SourcePart source, const PlanningRequest& request, SliceSummary& summary,
                      Progress& progress);

/// Checks that the machine reaches every pose of the toolpath. If the job's output is no program for the
/// machine and the layers or the orientation settings tilt the nozzle, only the tips are checked, and the
/// summary notes what head the poses need. Five-axis G-code is checked by `planJointProgram` instead.
/// @throws Unreachable
void requireWithin(const BuildSpace& space, const SliceJob& job, SlicedPart& sliced);

}  // namespace lamina
