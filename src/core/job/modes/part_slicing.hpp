// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "job/part/part_reading.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// Sets the entries of a summary that follow from the toolpath alone: lengths, counts, empty layers.
void addToolpath(SliceSummary& summary, const Toolpath& toolpath);

/// Checks that the build space allows the tool axis that plane layers need.
/// @throws Unreachable
void requireToolAxisFor(const SliceJob& job, const BuildSpace& space);

/// Reads the part that a job prints, and the base it is deposited on if the mode asks for one.
/// @throws InvalidMesh, FileError, Cancelled as `readPart`
SourcePart readSource(const SliceJob& job, Progress& progress);

/// The part as it is sliced: scaled for shrinkage, and placed on the bed.
struct PartOnBed {
  SourcePart source;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
};

/// Scales and places a part.
/// @throws Unreachable if the part, with what it is deposited on, is larger than the build space
PartOnBed partOnBed(SourcePart read, const SliceJob& job, const BuildSpace& space);

/// Makes the toolpath from a part that was read: places, slices and plans it, and checks it against the build
/// space. Of the times in the summary only the slicing time is set.
/// @throws as `runSliceJob`
SlicedPart sliceSource(SourcePart source, const SliceJob& job, const BuildSpace& space, Progress& progress,
                       const std::vector<ModeCandidate>& refused = {});

}  // namespace lamina
