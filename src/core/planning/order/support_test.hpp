// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/spatial/edge_bands.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The layer and supports below an inclined layer; the bed is considered separately.
struct BelowLayer {
  const Layer* layer = nullptr;       ///< the layer before; null for the first
  const Regions* supports = nullptr;  ///< carried up to the layer; null for none
};

/// Whether beads of an inclined layer are supported along the tool axis, by the layer before, a support or
/// the bed. A bead is supported where it touches the bed with its flank or its foot, or where its middle is
/// at most a quarter of its width beyond the edge of the layer before or a support, so that at least a
/// quarter of the bead rests on material.
class SupportTest {
 public:
  SupportTest(const Layer& layer, const BelowLayer& below, const BedPlane& bed, const Bead& bead);

  /// @param point  of a run, in the plane of the layer [mm]
  bool carries(const Point2& point) const;
  /// Whether the layer before or a support carries a bead there.
  bool isOnSupport(const Point2& point) const { return isOverMaterial(point); }
  /// Distance from the bed to the lowest corner of a bead at this point [mm]; negative if it is in the bed.
  double gapToBed(const Point2& point) const;

 private:
  bool touchesBed(const Point2& point) const;
  bool isOverMaterial(const Point2& anywhere) const;

  BedPlane bed_;
  double top_mm_;
  double reach_mm_;                 ///< by which a bead extends below its waypoint, towards the bed
  Point2 origin_ = Point2::Zero();  ///< origin of the edges' coordinates
  EdgeBands edges_;                 ///< edges of the supporting material, widened
};

}  // namespace lamina
