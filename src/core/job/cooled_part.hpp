// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// Gives layers their least times and controls the fan, as far as the job's output can carry it; drops have
/// neither. Where the machine does not reach beside the part, the nozzle waits over it. What is changed, and
/// what is left out, is noted in the summary.
/// @throws what `cool` throws; Cancelled
void coolPart(SlicedPart& sliced, const SliceJob& job, const BuildSpace& space, Progress& progress);

}  // namespace lamina
