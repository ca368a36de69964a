// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "infill/rectilinear/grid_sections.hpp"
#include "lamina/infill/rectilinear/hybrid_settings.hpp"

namespace lamina {

/// A perimeter in the raster frame, and the least distance of passes from it.
class PerimeterApproach {
 public:
  /// @param distance_mm  distance of passes: d of the documents
  PerimeterApproach(const std::vector<Polygon>& perimeter, double distance_mm,
                    const HybridSettings& settings);

  double spacing() const { return spacing_; }
  const HybridSettings& settings() const { return settings_; }

  /// Distance from a point to the nearest of the perimeter's points, which are at most
  /// `hybrid.perimeter_step` apart; infinite without a perimeter [mm].
  double distance(const Point2& point) const;

  /// The point on the line through `point` along `outward` that is as close to the perimeter as passes may
  /// be. With the method of two passes it is the point at that distance from its nearest perimeter point, on
  /// the inner side, computed twice; if that is out of reach, it is `point` itself. With the clipped method
  /// it is the point where the line meets the perimeter offset inwards: in the direction `outward` if `point`
  /// is inside the offset, in the opposite one otherwise.
  /// @param outward  unit vector along x or y
  Point2 approached(const Point2& point, const Point2& outward, int iterations = 2) const;

 private:
  const Point2& nearest(const Point2& point) const;
  Point2 movedTowardsNearest(const Point2& point, const Point2& outward) const;
  Point2 clipped(const Point2& point, const Point2& outward) const;

  HybridSettings settings_;
  double spacing_;
  std::vector<Point2> points_;    ///< points of the perimeter, sorted by x
  std::vector<Polygon> inwards_;  ///< the perimeter offset inwards by the least distance
};

/// Moves both ends of each pass to their distance from the perimeter [Flores2018, figures 55 to 59]. With the
/// method of two passes, passes of one point are unchanged.
void adaptLongitudinally(std::vector<GridSection>& sections, const PerimeterApproach& perimeter);

/// Adapts the first and the last pass of each section to the perimeter along which it lies [Flores2018,
/// figures 60 to 63]. With D the distance from the middle of the pass to the perimeter: if D is above
/// `hybrid.add_above`, a curve along the perimeter is added; if it is below `hybrid.delete_below` or the pass
/// is a point, the curve replaces the pass; otherwise one point is added.
void adaptTransversally(std::vector<GridSection>& sections, const PerimeterApproach& perimeter);

}  // namespace lamina
