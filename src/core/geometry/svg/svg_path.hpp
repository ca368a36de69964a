// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string_view>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// An ellipse of SVG in its own coordinates.
struct SvgEllipse {
  Point2 centre = Point2::Zero();
  Point2 radii = Point2::Zero();
  double turn_rad = 0.0;
};

/// Draws outlines through a map. Curves become chords that lie within 0.005 mm of the curve.
class SvgPen {
 public:
  explicit SvgPen(const Eigen::Affine2d& mm_from_user) : map_(mm_from_user) {}

  void moveTo(const Point2& point);
  void lineTo(const Point2& point);
  void quadraticTo(const Point2& control, const Point2& end);
  void cubicTo(const Point2& first, const Point2& second, const Point2& end);
  /// Draws along an ellipse, from one value of its angle parameter to another.
  void ellipticTo(const SvgEllipse& ellipse, double begin_rad, double end_rad);
  void close();

  Point2 at() const { return at_; }
  /// The outlines drawn so far [mm]; outlines of fewer than three points are left out.
  std::vector<Polygon> finish() &&;

 private:
  void add(const Point2& point);

  Eigen::Affine2d map_;
  Point2 at_ = Point2::Zero();
  Point2 begin_ = Point2::Zero();
  Polygon outline_;
  std::vector<Polygon> outlines_;
};

/// The outlines of path data (attribute `d`) [mm]; nothing if the data are invalid. Open outlines are closed.
std::optional<std::vector<Polygon>> svgPath(std::string_view data, const Eigen::Affine2d& mm_from_user);

}  // namespace lamina
