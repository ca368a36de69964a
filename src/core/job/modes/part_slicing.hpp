// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "job/part/part_reading.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// What the toolpath itself says of a summary: lengths, counts, empty layers.
void addToolpath(SliceSummary& summary, const Toolpath& toolpath);

/// Plane layers need the tool axis of the build space.
/// @throws Unreachable
void requireToolAxisFor(const SliceJob& job, const BuildSpace& space);

/// Reads what a job prints, and what it is deposited on where its mode asks for that.
/// @throws InvalidMesh, FileError, Cancelled as `readPart`
SourcePart readSource(const SliceJob& job, Progress& progress);

/// What is sliced: as large as it must be before it shrinks, and where it stands.
struct PartOnBed {
  SourcePart source;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
};

/// @throws Unreachable if the part, with what it is deposited on, is larger than the build space
PartOnBed partOnBed(SourcePart read, const SliceJob& job, const BuildSpace& space);

/// Everything between mesh and program: places, slices and plans what was read, and checks it against the
/// build space. Of the times in the summary only that of slicing is set.
/// @throws as `runSliceJob`
SlicedPart sliceSource(SourcePart source, const SliceJob& job, const BuildSpace& space, Progress& progress,
                       const std::vector<ModeCandidate>& refused = {});

}  // namespace lamina
