// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "lamina/base/progress.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// Makes the toolpath of a job: reads, slices and plans. It sets the times of reading and of slicing in the
/// summary.
using SliceFunction =
    std::function<SlicedPart(const SliceJob& job, const BuildSpace& space, Progress& progress)>;

/// Runs a job in a build space, whatever head the settings' machine has: checks the job, calls `slice`,
/// cools, plans joints, estimates the time and writes the output.
/// @throws as `runSliceJob`
SlicedPart runIn(const BuildSpace& space, const SliceJob& job, const SliceFunction& slice,
                 Progress& progress);

}  // namespace lamina
