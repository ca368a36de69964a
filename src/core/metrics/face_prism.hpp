// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "lamina/geometry/vector.hpp"
#include "metrics/straight_beads.hpp"

namespace lamina {

/// The half plane normal . p <= offset; the whole plane if the normal is 0.
struct HalfPlane {
  Point2 normal = Point2::Zero();
  double offset = 0.0;
};

/// A band with round ends on a face.
struct Band {
  Point2 start = Point2::Zero();  ///< start of the centre line [mm, face frame]
  Point2 end = Point2::Zero();
  double radius = 0.0;  ///< half the width [mm]
  /// Half planes that cut it off where it meets the bands that it is joined to.
  HalfPlane from_before, to_after;
};

/// How a piece of bead is projected onto a face.
struct Imprint {
  double radius_mm = 0.0;  ///< half the width of its band
  double depth_mm = 0.0;   ///< depth below the face down to which the middle of the piece counts
  double margin_mm = 0.0;  ///< distance beside the face within which the piece counts
  double beyond_mm =
      0.0;  ///< by which the band extends beyond the piece's ends, as a bead is rounder than its height
};

/// A triangle with a frame of its own, whose x is oblique to its edges, and the prism below it.
class FacePrism {
 public:
  /// @param corners  counter-clockwise seen from outside; with an area above 0
  explicit FacePrism(const std::array<Point3, 3>& corners);

  const Point3& normal() const { return normal_; }
  double area() const { return area_; }
  /// The corners, counter-clockwise [mm, face frame].
  const std::array<Point2, 3>& corners() const { return corners_; }
  Point2 onFace(const Point3& point) const;

  /// Bounding box of the prism of that depth, widened to the sides by the margin.
  Box3 box(double depth_mm, double margin_mm) const;

  /// The band of a piece on the face: of the part of the piece that lies in the prism, widened to the sides
  /// by a margin. Nothing if no part does.
  std::optional<Band> band(const StraightBead& piece, const Imprint& imprint) const;

 private:
  Point3 origin_;
  Point3 x_, y_, normal_;  // unit vectors, normal outwards
  std::array<Point3, 3> in_space_;
  std::array<Point2, 3> corners_;
  std::array<HalfPlane, 3> sides_;
  double area_ = 0.0;
};

/// The half plane at which two joined bands are cut: bounded by the bisector of their directions through
/// their joint. Nothing is cut if the path turns by more than 120 deg.
/// @param direction, next  directions of the bands [face frame], of any length
HalfPlane bisector(const Point2& direction, const Point2& next, const Point2& joint);

}  // namespace lamina
