// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/voids/beads/void_class.hpp"

namespace lamina {

/// How finely layers are looked at. Lengths are in pitches, the mean plan width of the layer's beads.
struct VoidMapSettings {
  /// Between the lines along x on which beads and contours are compared. Not a whole part of the pitch, so
  /// that beads along x meet these lines at all heights.
  double line_spacing = 0.0618;
  double least_void =
      0.02;  ///< area in squared pitches; smaller ones are counted as uncovered, but not listed
};

/// One connected part of a layer that no bead reaches, or that too many do.
struct Void {
  Region outline;  ///< [mm]; true within a line spacing
  double area_mm2 = 0.0;
  VoidClass kind = VoidClass::Between;
};

/// How the deposit of a layer fills its contour.
///
/// Uncovered is what no bead reaches; a bead reaches half its width from its centre line, and a drop half its
/// own. Overfill counts by volume, each bead as wide as it fills (`planWidth`): where passes lie on each
/// other, all but one of them count as overfill, and outside of the contour all. Places of a run within one
/// and a half widths of each other along it are one pass, so that bends are no overlap.
struct LayerVoids {
  double z_mm = 0.0;           ///< top of the layer
  double pitch_mm = 0.0;       ///< mean plan width of the beads by length; 0 if nothing is deposited
  double area_mm2 = 0.0;       ///< within the contour
  double deposited_mm2 = 0.0;  ///< volume over height of the layer
  double uncovered_mm2 = 0.0;
  double overfill_mm2 = 0.0;
  double outside_mm2 = 0.0;       ///< of the overfill, what beads fill outside of the contour
  std::size_t runs = 0;           ///< that deposit
  std::vector<Void> voids;        ///< from bottom to top, at least `least_void` large
  std::vector<Region> overfills;  ///< where overfill is, as large at least
};

/// Compares what a layer deposits (travel and skirt left out) with its contour.
/// @param contour  united; the deposit's frame [mm]
/// @throws InvalidInput if the settings are out of range
LayerVoids findVoids(const Regions& contour, const ToolpathLayer& layer, const VoidMapSettings& settings);

/// The same for all layers, side by side.
/// @param contours  one per layer
/// @throws InvalidInput if they are not as many, or the layers are inclined; Cancelled
std::vector<LayerVoids> findVoids(const std::vector<Regions>& contours, const Toolpath& toolpath,
                                  const VoidMapSettings& settings, Progress& progress);

}  // namespace lamina
