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

/// Resolution of the search for voids. Lengths are in pitches; the pitch is the mean plan width of the
/// layer's beads.
struct VoidMapSettings {
  /// Distance of the scan lines along x on which beads and contours are compared. No integer fraction of the
  /// pitch, so that these lines cross beads along x at all offsets from their middle.
  double line_spacing = 0.0618;
  /// Area, in squared pitches, below which voids count as uncovered, but are not listed.
  double least_void = 0.02;
};
/// A connected area inside the contour of a layer that no bead covers.
struct Void {
  Region outline;  ///< [mm], accurate to the distance of the scan lines
  double area_mm2 = 0.0;
  VoidClass kind = VoidClass::Between;
};
/// How the beads of a layer fill its contour.
///
/// An area is uncovered if it is farther than half a bead's width from the centre line of every bead, and
/// farther than half a drop's width from the centre of every drop. Overfill is found with beads of the width
/// that they fill (`planWidth`), so that it corresponds to volume. Where several passes cover an area, all
/// but one of them count as overfill; outside of the contour all of them do. Points of a path at most one and
/// a half widths apart along the path belong to one pass: bends are no overlap.
struct LayerVoids {
  double z_mm = 0.0;              ///< top of the layer
  double pitch_mm = 0.0;          ///< mean plan width of the beads by length; 0 if nothing is deposited
  double area_mm2 = 0.0;          ///< area inside the contour
  double deposited_mm2 = 0.0;     ///< deposited volume over the height of the layer
  double uncovered_mm2 = 0.0;     ///< area that is uncovered
  double overfill_mm2 = 0.0;      ///< area of overfill
  double outside_mm2 = 0.0;       ///< area of overfill outside of the contour
  std::size_t runs = 0;           ///< number of paths that deposit
  std::vector<Void> voids;        ///< those of at least `least_void`, from low to high y
  std::vector<Region> overfills;  ///< areas of overfill of at least `least_void` [mm]
};
/// Finds the voids and the overfill of a layer. Travels and build aids such as skirts are ignored.
/// @param contour  of the layer, without overlaps [mm, frame of the toolpath]
/// @throws InvalidInput if the settings are out of range
LayerVoids findVoids(const Regions& contour, const ToolpathLayer& layer, const VoidMapSettings& settings);

/// Finds the voids and the overfill of all layers, in parallel.
/// @param contours  one per layer
/// @throws InvalidInput if the numbers of contours and layers differ, or the layers are inclined; Cancelled
std::vector<LayerVoids> findVoids(const std::vector<Regions>& contours, const Toolpath& toolpath,
                                  const VoidMapSettings& settings, Progress& progress);

}  // namespace lamina
