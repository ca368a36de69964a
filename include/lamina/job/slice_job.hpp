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

/// A request to slice a part into a program.
struct SliceJob {
  std::string part;    ///< path of a mesh file, or the name of a parametric part (`partNames`)
  std::string output;  ///< file to write, in the format of its suffix; empty for none
  JobSettings settings;
};

/// A sliced part. The toolpath is in the coordinates of the part's file, even if its layers are inclined.
struct SlicedPart {
  Toolpath toolpath;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  SliceSummary summary;
};

/// Makes a program from a mesh file: reads and repairs the mesh, slices and plans it, checks the toolpath
/// against the machine, and writes the program. Everything is checked before the output is touched.
///
/// A machine with rotary joints gets five-axis G-code where the toolpath tilts the nozzle. A RAPID program of
/// an arm is checked against the arm's joints, and states their configuration if the settings ask for it.
///
/// @param progress  stages "read", "slice", "plan", "joints" if joint values are planned, "write"
/// @throws FileError, InvalidMesh, InvalidConfig, InvalidInput (no layer, unknown suffix, G-code for a
///   robot), Unreachable (a part larger than the machine, or a program that it cannot run), Cancelled
SlicedPart runSliceJob(const SliceJob& job, Progress& progress);

/// Slices the part in level layers for comparison, as if the head of the job's machine were upright.
/// @throws as `runSliceJob`
SlicedPart runLevelSliceJob(SliceJob job, Progress& progress);

}  // namespace lamina
