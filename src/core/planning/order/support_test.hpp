// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Tells whether beads of an inclined layer are supported along the tool axis, by the layer before or the
/// bed. A bead is supported where it touches the bed with its flank or its foot, or where its middle is at
/// most a quarter of its width beyond the edge of the layer before, so that a quarter of it lies on that
/// layer.
class SupportTest {
 public:
  /// @param below  the layer before; null for the first
  SupportTest(const Layer& layer, const Layer* below, const BedPlane& bed, const Bead& bead);

  /// @param point  of a run, in the plane of the layer [mm]
  bool carries(const Point2& point) const;

 private:
  bool touchesBed(const Point2& point) const;
  bool isOverMaterial(const Point2& anywhere) const;
  std::size_t rowOf(double y) const;

  BedPlane bed_;
  double top_mm_;
  double reach_mm_;                 ///< of a bead below its waypoint, towards the bed
  Point2 origin_ = Point2::Zero();  ///< of the rows
  double low_y_ = 0.0;
  double row_mm_ = 1.0;
  std::vector<std::vector<std::pair<Point2, Point2>>> rows_;  ///< edges of the layer before by their y
};

}  // namespace lamina
