// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "job/part/part_source.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/planning/planner.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// What a part is planned by, and where it stands.
struct PlanningRequest {
  const SliceJob& job;
  const CartesianMachine& machine;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();

  /// Name of the part: its file's without folder and suffix.
  std::string partName() const;
};

/// What cutting a part into layers gave.
struct LayerCounts {
  std::size_t layers = 0;
  std::size_t contours = 0;       ///< closed ones
  std::size_t open_contours = 0;  ///< none on a closed mesh
  double sliced_volume_mm3 = 0.0;
  double slice_s = 0.0;
};

/// A part's toolpath in the part frame, and how it came about.
struct PlannedPart {
  Plan plan;
  LayerCounts counts;
  OverhangAngle lean;
  std::vector<std::string> notes;  ///< what a user should know of the layers, a sentence each
};

/// Counts of layers that lie in parallel planes.
LayerCounts countsOf(const std::vector<Layer>& layers);

/// Slices the part by a mode and plans its layers. The mesh is gone when they are planned.
/// @param mode  not `Auto`
/// @throws InvalidMesh (`Unsliceable` with a region), InvalidInput (no layer), InvalidConfig, Unreachable,
/// Cancelled
PlannedPart planByMode(SourcePart source, SlicingMode mode, const PlanningRequest& request,
                       Progress& progress);

/// By parallel planes, level or inclined.
PlannedPart planPlanar(SourcePart source, const PlanningRequest& request, Progress& progress);

/// By shells of the lower and upper surface, and level layers between them.
PlannedPart planCurved(SourcePart source, const PlanningRequest& request, Progress& progress);

/// By layers adapted to a wall that leans: the wall alone if one wall without infill is asked for, otherwise
/// walls and infill on the surfaces that its curves span.
PlannedPart planAdapted(SourcePart source, const PlanningRequest& request, Progress& progress);

/// By layers on a base, or a coat on the part.
PlannedPart planConformal(SourcePart source, const PlanningRequest& request, Progress& progress);

/// By layers that bend to follow the part's upper side, the nozzle straight down.
PlannedPart planHeightField(SourcePart source, const PlanningRequest& request, Progress& progress);

}  // namespace lamina
