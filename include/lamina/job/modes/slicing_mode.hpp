// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <limits>
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

/// Input for the planning by a mode: job, machine, and the part's pose on the bed.
struct PlanningRequest {
  const SliceJob& job;
  const BuildSpace& space;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  /// Modes whose layers the machine cannot run, as earlier choices of `auto` have found.
  std::vector<ModeCandidate> refused = {};

  /// Name of the part: that of its file without folder and suffix.
  std::string partName() const;
};

/// Figures of cutting a part into layers.
struct LayerCounts {
  std::size_t layers = 0;
  std::size_t contours = 0;       ///< number of closed contours
  std::size_t open_contours = 0;  ///< number of open contours; 0 for a closed mesh
  double sliced_volume_mm3 = 0.0;
  double slice_s = 0.0;  ///< time that the cutting took
};

/// Measures of how well a mode's layers support each other.
struct SupportMeasures {
  /// Surface that overhangs the mode's own layers by more than its settings allow.
  double unsupported_mm2 = 0.0;
  /// Number of pieces printed along one direction; each curved layer is a piece of its own.
  std::size_t steps = 1;
  Mesh unsupported = {};  ///< triangles of that surface [part frame]
};

/// A part's toolpath [part frame], and figures of its planning.
struct PlannedPart {
  Plan plan;
  LayerCounts counts;
  std::optional<SupportMeasures> support;  ///< only from modes that measure it themselves
  OverhangAngle lean;                      ///< greatest overhang of the walls
  std::vector<std::string> notes;          ///< notes for the user on the layers, a sentence each
  /// Highest z of solid material on the bed before the first layer, such as a base [mm, part frame].
  double standing_mm = -std::numeric_limits<double>::infinity();
  bool is_fitted = false;  ///< whether the mode has fitted the toolpath to the machine itself
};

/// Slices a part and plans its layers. The source is consumed.
/// @throws InvalidMesh (`Unsliceable` with a region), InvalidInput (no layer), InvalidConfig, Unreachable,
///   Cancelled
using PlanFunction =
    std::function<PlannedPart(SourcePart source, const PlanningRequest& request, Progress& progress)>;

/// Geometry of the layers of a mode.
enum class LayerShape {
  Plane,  ///< parallel planes: level, or as `slicing.plane` inclines them
  Bent,   ///< any other surfaces, on which skirt, scan passes, copies and drop voids are not supported
};

/// Whether a mode uses `slicing.first_layer_height_mm`.
enum class FirstLayer {
  OwnHeight,   ///< it is the height of the first layer
  SameHeight,  ///< it is not used: all layers have the same height
};

/// What the first layer of a mode is deposited on.
enum class DepositedOn {
  Bed,
  Base,  ///< `conformal.base`, if it is set
};

/// Machines on which `auto` tries a mode.
enum class AutoTrial {
  None,         ///< never: the mode has to be named
  AnyHead,      ///< on all machines
  TiltingHead,  ///< on machines that can tilt the nozzle
};

/// A slicing mode: how a part is cut into layers, with the properties of the layers that a job needs.
struct SlicingMode {
  PlanFunction plan;
  LayerShape shape = LayerShape::Bent;
  FirstLayer first_layer = FirstLayer::OwnHeight;
  DepositedOn deposited_on = DepositedOn::Bed;
  AutoTrial auto_trial = AutoTrial::None;
  /// Rank in the order in which `auto` tries modes, the lowest first: modes that are simpler to print have
  /// lower ranks. Lamina's own modes have ranks 0 to 3. Modes of equal rank are tried in alphabetical order.
  int auto_turn = 4;
};

/// Value of `slicing.mode` with which the mode is chosen by part and machine. It is not itself a mode.
inline constexpr const char* kAutoMode = "auto";

/// All modes by name, those of plug-ins included. A plug-in adds one by `slicingModes().add("name", {...})`.
Registry<SlicingMode>& slicingModes();

/// Allowed values of `slicing.mode`: the names of all modes, and `auto`.
std::vector<std::string> slicingModeNames();

/// Whether the layers of a mode lie in parallel planes; false for `auto`.
/// @throws InvalidConfig if there is no mode of that name
bool hasPlaneLayers(const std::string& mode);

}  // namespace lamina
