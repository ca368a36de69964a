// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/slice_summary.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// One request: which part becomes which program, and how.
struct SliceJob {
  std::string part;    ///< path of a mesh file, or the name of a parametric part (`partNames`)
  std::string output;  ///< file to write, its suffix chooses the writer; empty for none
  JobSettings settings;
};

/// A part ready to print. The toolpath keeps the coordinates of the part's file, inclined layers too.
struct SlicedPart {
  Toolpath toolpath;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  SliceSummary summary;
};

/// From mesh file to written program: reads and repairs, slices, plans, checks against the machine, writes.
/// Everything is checked before the output is touched.
///
/// A machine with rotary joints gets five-axis G-code where the toolpath tilts the nozzle; an arm's program
/// in RAPID is checked against its joints, and states them where the settings ask for that.
///
/// @param progress  stages "read", "slice", "plan", "joints" where joints are led, "write"
/// @throws FileError, InvalidMesh, InvalidConfig, InvalidInput (no layer, unknown suffix, G-code for a
///   robot), Unreachable (larger than the machine, or a program that it cannot run), Cancelled
SlicedPart runSliceJob(const SliceJob& job, Progress& progress);

/// The part in level layers, for comparison: on the machine of the job with its head upright.
/// @throws as `runSliceJob`
SlicedPart runLevelSliceJob(SliceJob job, Progress& progress);

}  // namespace lamina
