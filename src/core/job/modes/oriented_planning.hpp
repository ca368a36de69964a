// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job/modes/part_planning.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// Plans a part by its mode, the best one if that is `Auto`, and holds the nozzle as the settings say. What
/// there is to report stands in the summary.
/// @throws as `planByMode`; InvalidInput if the nozzle would be held too far off the layers' normal
Toolpath planOriented(SourcePart source, const PlanningRequest& request, SliceSummary& summary,
                      Progress& progress);

/// A program must be one for the machine: every pose is checked. Of poses in a file, or nowhere, only the
/// tips are, if the layers or the orientation settings tilt the nozzle; the summary notes what head they
/// need. Five-axis G-code is left to `planJointProgram`.
/// @throws Unreachable
void requireWithin(const BuildSpace& space, const SliceJob& job, SlicedPart& sliced);

}  // namespace lamina
