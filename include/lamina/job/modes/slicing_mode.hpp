// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/base/registry.hpp"
#include "lamina/job/modes/mode_candidate.hpp"
#include "lamina/job/part/source_part.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/planning/planner.hpp"

namespace lamina {

/// What a part is planned by, and where it stands.
struct PlanningRequest {
  const SliceJob& job;
  const BuildSpace& space;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  std::vector<ModeCandidate> refused = {};  ///< of what `auto` may choose: known not to be had

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

/// What a mode knows of its own layers.
struct LayerSupport {
  double unsupported_mm2 =
      0.0;                ///< of the surface: overhangs its own layers by more than the mode's settings take
  std::size_t steps = 1;  ///< pieces printed along one direction; each bent layer is one of its own
  Mesh unsupported = {};  ///< triangles of what overhangs so [part frame]
};

/// A part's toolpath in the part frame, and how it came about.
struct PlannedPart {
  Plan plan;
  LayerCounts counts;
  std::optional<LayerSupport> support;  ///< of modes that measure it
  OverhangAngle lean;
  std::vector<std::string> notes;  ///< what a user should know of the layers, a sentence each
};

/// Slices a part and plans its layers. The mesh is gone when they are planned.
/// @throws InvalidMesh (`Unsliceable` with a region), InvalidInput (no layer), InvalidConfig, Unreachable,
/// Cancelled
using PlanFunction =
    std::function<PlannedPart(SourcePart source, const PlanningRequest& request, Progress& progress)>;

/// How the layers of a mode lie.
enum class LayerShape {
  Plane,  ///< in parallel planes: level, or as `slicing.plane` says
  Bent,   ///< anyhow: without skirt, scan passes, copies and drop voids
};

/// What `slicing.first_layer_height_mm` means to a mode.
enum class FirstLayer {
  OwnHeight,   ///< the first layer has it
  SameHeight,  ///< nothing: all layers are as high
};

/// What the first layer of a mode is deposited on.
enum class DepositedOn {
  Bed,
  Base,  ///< `conformal.base`, if it is set
};

/// On which machines `auto` tries a mode.
enum class AutoTrial {
  None,         ///< it is had by its name only
  AnyHead,      ///< on all
  TiltingHead,  ///< where the nozzle may tilt
};

/// A kind of layers that a part can be cut into, and what a job has to know about it.
struct SlicingMode {
  PlanFunction plan;
  LayerShape shape = LayerShape::Bent;
  FirstLayer first_layer = FirstLayer::OwnHeight;
  DepositedOn deposited_on = DepositedOn::Bed;
  AutoTrial auto_trial = AutoTrial::None;
  /// Place among the modes that `auto` tries, the lowest first: the simpler to print, the lower. Lamina's own
  /// have 0 to 3; modes of one turn are tried in the order of their names.
  int auto_turn = 0;
};

/// The value of `slicing.mode` that leaves the choice to the part and the machine: no mode of its own.
inline constexpr const char* kAutoMode = "auto";

/// All modes, those of plug-ins too. Whoever adds one calls `slicingModes().add("name", {...})`.
Registry<SlicingMode>& slicingModes();

/// What `slicing.mode` may be: the names of all modes, and `auto`.
std::vector<std::string> slicingModeNames();

/// Whether the layers of a mode lie in parallel planes; false for `auto`.
/// @throws InvalidConfig if there is no mode of that name
bool hasPlaneLayers(const std::string& mode);

}  // namespace lamina
