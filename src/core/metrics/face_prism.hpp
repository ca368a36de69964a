// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "lamina/geometry/vector.hpp"
#include "metrics/straight_beads.hpp"

namespace lamina {

/// Keeps a half of the plane: where normal . p <= offset. A normal of 0 keeps all of it.
struct HalfPlane {
  Point2 normal = Point2::Zero();
  double offset = 0.0;
};

/// A band with round ends on a face.
struct Band {
  Point2 start = Point2::Zero();  ///< of the middle line [mm, face frame]
  Point2 end = Point2::Zero();
  double radius = 0.0;  ///< half the width [mm]
  /// Where it meets the bands that it is joined to.
  HalfPlane from_before, to_after;
};

/// What a piece is to a face.
struct Imprint {
  double radius_mm = 0.0;  ///< half the width of the band it lays
  double depth_mm = 0.0;   ///< below the face within which its middle counts
  double margin_mm = 0.0;  ///< beside the face within which it counts
  double beyond_mm =
      0.0;  ///< by which the band goes on beyond its own ends: a bead is rounder than its height
};

/// A triangle with a frame of its own, whose x lies askew to its edges, and the prism below it.
class FacePrism {
 public:
  /// @param corners  counter-clockwise seen from outside; must have an area
  explicit FacePrism(const std::array<Point3, 3>& corners);

  const Point3& normal() const { return normal_; }
  double area() const { return area_; }
  /// Counter-clockwise [mm, face frame].
  const std::array<Point2, 3>& corners() const { return corners_; }
  Point2 onFace(const Point3& point) const;

  /// Around a prism so deep, widened to the sides.
  Box3 box(double depth_mm, double margin_mm) const;

  /// The band that a piece lays on the face: what of it lies in the prism, widened to the sides by a margin.
  std::optional<Band> band(const StraightBead& piece, const Imprint& imprint) const;

 private:
  Point3 origin_;
  Point3 x_, y_, normal_;  // unit vectors, normal outwards
  std::array<Point3, 3> in_space_;
  std::array<Point2, 3> corners_;
  std::array<HalfPlane, 3> sides_;
  double area_ = 0.0;
};

/// Cuts two joined bands where they meet: at the bisector of their directions. Nothing is cut where a path
/// turns back by more than 120 deg.
/// @param direction, next  of the bands [face frame], of any length
HalfPlane bisector(const Point2& direction, const Point2& next, const Point2& joint);

}  // namespace lamina
