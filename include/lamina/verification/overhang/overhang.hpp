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

/// Kind of a stretch of bead with nothing below it along the tool axis.
enum class StretchKind {
  Bridge,    ///< both ends are supported, and it is within half a width of the straight line between them
  Overhang,  ///< any other: it is supported at one end or none, or follows a curve
};

/// The name of a kind: "bridge", "overhang".
const char* toString(StretchKind kind);

/// A stretch of bead that nothing supports, from support to support or to the end of its run. A run is
/// material deposited without interruption.
struct UnsupportedStretch {
  StretchKind kind = StretchKind::Overhang;
  WaypointIndex at;                  ///< end of the motion on which the stretch begins
  PathRole role = PathRole::Infill;  ///< of the path on which it begins
  bool begins_run = false;           ///< whether its run begins with it
  double length_mm = 0.0;
  double width_mm = 0.0;  ///< of the bead where it begins
  /// Positions of the nozzle tip from begin to end [mm, part frame]: at least two, one for a drop.
  std::vector<Point3> points;
};

/// Lengths of unsupported beads in one layer.
struct LayerOverhang {
  double deposited_mm = 0.0;      ///< length of all beads
  double overhang_mm = 0.0;       ///< length of overhangs
  double bridge_mm = 0.0;         ///< length of bridges
  std::size_t starts_in_air = 0;  ///< number of runs that begin with nothing below them

  /// Length of overhangs and bridges [mm].
  double unsupported() const { return overhang_mm + bridge_mm; }
};

/// The beads of a toolpath that are deposited with nothing below them.
struct OverhangReport {
  std::vector<LayerOverhang> layers;  ///< one per layer; a stretch counts in the layer in which it begins
  std::vector<UnsupportedStretch> stretches;  ///< in the order of deposition
  std::size_t runs = 0;                       ///< number of runs
};

/// Totals of a report.
struct OverhangTotals {
  LayerOverhang all;          ///< sums over all layers
  std::size_t overhangs = 0;  ///< number of overhangs
  std::size_t bridges = 0;    ///< number of bridges
  double longest_overhang_mm = 0.0;
  double longest_bridge_mm = 0.0;
  double in_walls_mm = 0.0;  ///< length of stretches that begin in an outer or inner wall
  /// Index of the layer with the greatest unsupported length; nothing if all is supported.
  std::optional<std::size_t> worst_layer;

  /// Unsupported share of the length of all beads; 0 if nothing is deposited.
  double share() const { return all.deposited_mm > 0.0 ? all.unsupported() / all.deposited_mm : 0.0; }
};

/// Sums up a report.
OverhangTotals totals(const OverhangReport& report);

/// The longest stretches of a kind, at most `count`, the longest first; of equal ones the one deposited
/// first.
std::vector<UnsupportedStretch> longest(const OverhangReport& report, StretchKind kind, std::size_t count);

/// Finds the beads that are deposited with nothing below them along the tool axis.
///
/// Beads are sampled at most `step_mm` apart. The cross-section of a bead is a rectangle of its width and
/// height, below the nozzle tip along the layers' normal. A sample is supported if a ray along the tool axis,
/// from the middle of the section or from a point at most (1/2 - `overlap`) of the width beside it, meets the
/// bed or an earlier bead within `reach` bead heights, measured along the normal. A bead whose middle is less
/// than a quarter of the height farther along the tool axis counts as beside, not below. A drop counts as a
/// bead as long as its diameter.
///
/// Time is n log n in the number of motions; the result is the same for any number of threads.
///
/// @param bed_from_part  [mm]; the bed is z = 0 of its frame
/// @param progress       stage "overhang"
/// @throws InvalidInput if a tool axis is inclined to the layers' normal by more than 84 deg; Cancelled
OverhangReport findOverhangs(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                             const OverhangSettings& settings, Progress& progress);

}  // namespace lamina
