// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/job/modes/mode_candidate.hpp"
#include "lamina/orientation/orientation_report.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/order/fill_starts.hpp"
#include "lamina/planning/planner.hpp"
#include "lamina/toolpath/repositions.hpp"
#include "lamina/verification/overhang/overhang_angle.hpp"

namespace lamina {

/// What slicing a part gave, and what it took.
struct SliceSummary {
  std::string mode = "planar";            ///< that the layers were made by; never `auto`
  std::string mode_reason;                ///< why it was chosen; empty if the settings name it
  std::vector<ModeCandidate> candidates;  ///< that `auto` tried; empty if the settings name the mode
  std::vector<std::string> notes;         ///< what to know of the layers and the tool, a sentence each
  OverhangAngle lean;                     ///< of the part's walls over its layers
  OrientationReport orientation;          ///< all zero if the nozzle is held as the slicer gave it
  std::size_t triangles = 0;              ///< of the repaired mesh
  std::size_t layers = 0;
  std::size_t contours = 0;       ///< closed ones, of all layers
  std::size_t open_contours = 0;  ///< none on a closed mesh
  std::size_t deposition_runs = 0;
  Repositions repositions;
  FillStarts starts;
  AnchoredStarts anchored;
  Bridging bridging;
  double mesh_volume_mm3 = 0.0;    ///< of the repaired mesh
  double sliced_volume_mm3 = 0.0;  ///< signed area of the contours times layer height
  double deposition_mm = 0.0;
  double travel_mm = 0.0;
  double deposited_mm3 = 0.0;
  double unprinted_mm3 = 0.0;    ///< of what gets no bead or drop
  std::size_t empty_layers = 0;  ///< in which nothing is deposited, below others in which something is
  Refilling refilling;
  SupportTotals supports;
  double raft_mm = 0.0;  ///< by which the part stands above the bed
  double estimated_time_s = 0.0;
  /// Of the length of beads, deposited below 95 % of the feed asked for, within the limits of the joints;
  /// negative where no joints are led, and the time is that of the tip alone.
  double slow_bead_share = -1.0;
  std::vector<std::string> repairs;  ///< what was changed on the mesh and where
  double read_s = 0.0;               ///< reading and repairing
  double slice_s = 0.0;
  double plan_s = 0.0;
  double write_s = 0.0;
  double wall_s = 0.0;
  double peak_memory_mb = 0.0;  ///< most memory the process ever held [MiB]
};

}  // namespace lamina
