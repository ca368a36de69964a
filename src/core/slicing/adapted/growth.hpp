// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "lamina/slicing/adapted/adapted_layers.hpp"
#include "slicing/adapted/curve_length.hpp"
#include "slicing/adapted/curve_places.hpp"
#include "slicing/adapted/wall_strand.hpp"

namespace lamina {

/// A curve, where its places are and how far along it.
struct PlacedCurve {
  explicit PlacedCurve(AdaptedCurve placed);
  AdaptedCurve curve;
  CurvePlaces places;
  CurveLength length;
};

/// A point of a layer and what it stands on.
struct GrownPoint {
  Point3 point = Point3::Zero();
  Point3 axis = Point3::Zero();
  double height_mm = 0.0;   ///< from the curve below
  double foot_mm = 0.0;     ///< length along the curve below at which it stands
  bool is_reached = false;  ///< whether the flat contour was near enough, so that its point was taken
};

/// The curve through grown points, without those that would make it fold (`pointsInOrder`).
AdaptedCurve curveThrough(const std::vector<GrownPoint>& grown, bool is_closed, const PlacedCurve& below);

/// Draws flat contours of one wall down to a layer's height from the curve below.
class Growth {
 public:
  /// @param strand  must outlive this
  explicit Growth(const WallStrand& strand);

  /// The lowest flat contour above a height, or the number of contours if there is none.
  std::size_t firstAbove(double z) const;

  /// The point of the layer on `below` that grows towards point `i` of the flat contour `level`
  /// [Flores2018, figure 78]. If that is no farther than `height_mm`, it is taken itself.
  /// Otherwise the way there from the nearest place below is followed by that height, and the point put on
  /// the line between the two flat contours that enclose it, which lies along the wall, again at that height
  /// from the place below that is nearest then; of two such points the upper one. If the line is farther
  /// away than that, the point at that height nearest to it is taken.
  GrownPoint towards(std::size_t level, std::size_t i, const PlacedCurve& below, double height_mm) const;

 private:
  void returnToWall(GrownPoint& grown, std::size_t level, double foot_z, const PlacedCurve& below) const;
  void putOnWall(GrownPoint& grown, std::size_t above, const PlacedCurve& below) const;

  const WallStrand& strand_;
  std::vector<double> heights_;
  std::vector<std::unique_ptr<CurvePlaces>> places_;
};

}  // namespace lamina
