// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// Cools a sliced part (`cool`): slows layers down to their least times and controls the fan, as far as the
/// format of the job's output can express waits and fan speeds. Drops are left as they are. If the machine
/// does not reach the places beside the part, the nozzle waits over the part instead. The summary notes what
/// was changed and what could not be.
/// @throws as `cool`; Cancelled
void coolPart(SlicedPart& sliced, const SliceJob& job, const BuildSpace& space, Progress& progress);

/// The settings with `cooling.park` at `stay` where the machine does not reach the places beside the part.
CoolingSettings reachableParking(const SlicedPart& sliced, CoolingSettings cooling, const BuildSpace& space);

}  // namespace lamina
