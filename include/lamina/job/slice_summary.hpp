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

/// Figures of slicing a part: the result, and the time and memory that it took.
struct SliceSummary {
  std::string mode = "planar";            ///< mode by which the layers were made; never `auto`
  std::string mode_reason;                ///< why `auto` chose it; empty if the settings name the mode
  std::vector<ModeCandidate> candidates;  ///< modes that `auto` tried; empty if the settings name the mode
  std::vector<std::string> notes;         ///< notes for the user on the layers and the tool, a sentence each
  OverhangAngle lean;                     ///< greatest overhang of the part's walls
  OrientationReport orientation;  ///< all zero if the nozzle keeps the orientation that the slicer gave it
  std::size_t triangles = 0;      ///< number of triangles of the repaired mesh
  std::size_t layers = 0;
  std::size_t contours = 0;       ///< number of closed contours in all layers
  std::size_t open_contours = 0;  ///< number of open contours; 0 for a closed mesh
  std::size_t deposition_runs = 0;
  Repositions repositions;
  FillStarts starts;
  AnchoredStarts anchored;
  Bridging bridging;
  double mesh_volume_mm3 = 0.0;    ///< volume of the repaired mesh
  double sliced_volume_mm3 = 0.0;  ///< signed area of the contours times layer height
  double deposition_mm = 0.0;      ///< length of the runs that deposit
  double travel_mm = 0.0;          ///< length of the travels
  double deposited_mm3 = 0.0;
  double unprinted_mm3 = 0.0;  ///< volume of the part without a bead or drop
  /// Number of layers in which nothing is deposited, below layers in which something is.
  std::size_t empty_layers = 0;
  Refilling refilling;
  SupportTotals supports;
  double raft_mm = 0.0;  ///< height by which the raft lifts the part off the bed
  double estimated_time_s = 0.0;
  /// Share of the length of beads that is deposited at less than 95 % of the feed asked for, because of the
  /// limits of the joints. Negative if no joint values were planned; the estimated time is then that of the
  /// nozzle tip alone.
  double slow_bead_share = -1.0;
  std::vector<std::string> repairs;  ///< what was repaired on the mesh, and where
  double read_s = 0.0;               ///< time for reading and repairing
  double slice_s = 0.0;
  double plan_s = 0.0;
  double write_s = 0.0;
  double wall_s = 0.0;          ///< total time
  double peak_memory_mb = 0.0;  ///< greatest memory that the process has used so far [MiB]
};

}  // namespace lamina
