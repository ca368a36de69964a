// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/job/job_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// Spreads the starts of runs, overlaps their ends, adds leads and entries, weaves, with notes of what was
/// changed. Before layers are cooled, so that times are those of what is run. Totals of the
/// summary are those of what comes out.
/// @throws InvalidInput as `overlapEnds`
/// @throws Unreachable if the machine does not reach what was added
void changeRunsOf(SlicedPart& sliced, const JobSettings& settings, const BuildSpace& space);

}  // namespace lamina
