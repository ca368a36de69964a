// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/verification/overhang/overhang_settings.hpp"

namespace lamina {

/// A piece of a run with nothing below it along the tool axis.
enum class StretchKind {
  Bridge,    ///< both its ends are carried and it stays within half a width of the straight line between them
  Overhang,  ///< any other: it hangs on one end, on none, or goes round a curve
};

/// "bridge", "overhang".
const char* toString(StretchKind kind);

/// A piece of a run that nothing carries, as long as possible.
struct UnsupportedStretch {
  StretchKind kind = StretchKind::Overhang;
  WaypointIndex at;                  ///< to which the nozzle moves when it leaves what carries it
  PathRole role = PathRole::Infill;  ///< where it begins
  bool begins_run = false;           ///< nothing was deposited right before it
  double length_mm = 0.0;
  double width_mm = 0.0;       ///< of the bead where it begins
  std::vector<Point3> points;  ///< nozzle tip from begin to end [mm, part frame]; two at least, one of a drop
};

/// Overhang lengths of one layer.
struct LayerOverhang {
  double deposited_mm = 0.0;
  double overhang_mm = 0.0;
  double bridge_mm = 0.0;
  std::size_t starts_in_air = 0;  ///< runs that begin with nothing below them

  /// Length of both kinds [mm].
  double unsupported() const { return overhang_mm + bridge_mm; }
};

/// The parts of a toolpath that are deposited with nothing below them.
struct OverhangReport {
  std::vector<LayerOverhang> layers;  ///< as many as the toolpath has; a stretch counts where it begins
  std::vector<UnsupportedStretch> stretches;  ///< in the order in which they are deposited
  std::size_t runs = 0;                       ///< of deposition without a stop
};

/// Sums of a report.
struct OverhangTotals {
  LayerOverhang all;
  std::size_t overhangs = 0;
  std::size_t bridges = 0;
  double longest_overhang_mm = 0.0;
  double longest_bridge_mm = 0.0;
  double in_walls_mm = 0.0;                ///< unsupported length that begins in an outer or inner wall
  std::optional<std::size_t> worst_layer;  ///< with the greatest unsupported length; none if there is none

  /// Unsupported part of the length; 0 if nothing is deposited.
  double share() const { return all.deposited_mm > 0.0 ? all.unsupported() / all.deposited_mm : 0.0; }
};

OverhangTotals totals(const OverhangReport& report);

/// The longest stretches of a kind, the longest first; of equal ones the one deposited first.
std::vector<UnsupportedStretch> longest(const OverhangReport& report, StretchKind kind, std::size_t count);

/// Finds what is deposited with nothing below it along the tool axis.
///
/// Beads are looked at every `step_mm`. Their section is a box as wide and high as the bead, below the
/// nozzle tip along the layers' normal. A place is carried if a ray along the tool axis from the middle of
/// that section, or from anywhere up to (1/2 - overlap) of the width beside it, meets the bed or a bead
/// deposited before within `reach` bead heights, measured along the normal. A bead whose middle is less than
/// a quarter of the height farther along the tool axis lies beside, not below. A drop is a bead as long as
/// its diameter.
///
/// n log n in the number of motions; the same whatever the number of threads.
///
/// @param bed_from_part  [mm]; the bed is z = 0 of its frame
/// @param progress       stage "overhang"
/// @throws InvalidInput if a tool axis is inclined to the layers' normal by more than 84 deg; Cancelled
OverhangReport findOverhangs(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                             const OverhangSettings& settings, Progress& progress);

}  // namespace lamina
