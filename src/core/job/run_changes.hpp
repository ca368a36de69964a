// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/job/job_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// Changes runs as the settings ask: spreads their starts, overlaps their ends, adds leads and entries, and
/// weaves. Notes go to the summary. Must precede cooling, which counts the times of the changed layers.
/// Totals of the summary are computed anew.
/// @throws InvalidInput as `overlapEnds`
/// @throws Unreachable if the machine does not reach what was added
void changeRunsOf(SlicedPart& sliced, const JobSettings& settings, const BuildSpace& space);

}  // namespace lamina
