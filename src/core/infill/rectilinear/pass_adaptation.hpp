// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "infill/rectilinear/grid_sections.hpp"
#include "lamina/infill/rectilinear/hybrid_settings.hpp"

namespace lamina {

/// A perimeter in the raster frame, and how near passes may come to it.
class PerimeterApproach {
 public:
  /// @param distance_mm  between passes: d of the documents
  PerimeterApproach(const std::vector<Polygon>& perimeter, double distance_mm,
                    const HybridSettings& settings);

  double spacing() const { return spacing_; }
  const HybridSettings& settings() const { return settings_; }

  /// From a point to the nearest of the perimeter's points, which are no farther apart than
  /// `hybrid.perimeter_step`; infinite without a perimeter [mm].
  double distance(const Point2& point) const;

  /// The point on the line through `point` in that direction that is as near to the perimeter as passes may
  /// come. In two passes: the point at that distance from its nearest perimeter point, on the inner side, and
  /// once more from there; where that is out of reach, the point itself. Clipped: where the line meets the
  /// perimeter offset inwards, onwards from a point inside of that and back from one outside.
  /// @param outward  unit vector along x or y
  Point2 approached(const Point2& point, const Point2& outward, int iterations = 2) const;

 private:
  const Point2& nearest(const Point2& point) const;
  Point2 movedTowardsNearest(const Point2& point, const Point2& outward) const;
  Point2 clipped(const Point2& point, const Point2& outward) const;

  HybridSettings settings_;
  double spacing_;
  std::vector<Point2> points_;    ///< of the perimeter, by x
  std::vector<Polygon> inwards_;  ///< the perimeter offset by the approach
};

/// Brings both ends of each pass to their distance from the perimeter [Flores2018, figures 55 to 59]. In two
/// passes, those of one point stay.
void adaptLongitudinally(std::vector<GridSection>& sections, const PerimeterApproach& perimeter);

/// Brings the zigzag to its distance from the perimeters it lies along [Flores2018, figures 60 to 63], at the
/// first and last pass of each section: with D from the middle of the pass to the perimeter, a curve along
/// the perimeter is added if D is above `hybrid.add_above`; it replaces the pass if D is below
/// `hybrid.delete_below` or the pass is a point; in between one point is added.
void adaptTransversally(std::vector<GridSection>& sections, const PerimeterApproach& perimeter);

}  // namespace lamina
