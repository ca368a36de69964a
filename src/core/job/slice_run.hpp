// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "lamina/base/progress.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// What stands between a job and its toolpath: reads, slices and plans. Of the times in the summary it sets
/// those of reading and slicing.
using SliceFunction =
    std::function<SlicedPart(const SliceJob& job, const BuildSpace& space, Progress& progress)>;

/// Everything around it: checks the job, cools, leads joints, estimates the time, writes. In the build space,
/// whatever head the settings' machine has.
/// @throws as `runSliceJob`
SlicedPart runIn(const BuildSpace& space, const SliceJob& job, const SliceFunction& slice,
                 Progress& progress);

}  // namespace lamina
