// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics/face_prism.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

/// Lines of measurement that run along edges, or along what is deposited parallel or square to them, would
/// see a gap either whole or not at all.
constexpr double kAskew = 0.553574;  // rad: no simple fraction of a turn
constexpr double kOnFace = 1e-6;     // mm above the face that still count as on it
constexpr double kLeastDirection = 1e-9;
constexpr double kSharpestJoint = -0.5;  // cosine of the turn

/// The part of a segment, as shares of its length.
struct Share {
  double from = 0.0;
  double to = 1.0;
  bool isEmpty() const { return from > to; }

  /// Keeps where a value that changes evenly from `start` to `end` is at most `most`.
  void keepBelow(double start, double end, double most) {
    const double change = end - start;
    if (change == 0.0) {
      if (start > most) to = -1.0;
      return;
    }
    const double at = (most - start) / change;
    change > 0.0 ? to = std::min(to, at) : from = std::max(from, at);
  }
};

}  // namespace

FacePrism::FacePrism(const std::array<Point3, 3>& corners) : origin_(corners[0]), in_space_(corners) {
  const Point3 across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  area_ = 0.5 * across.norm();
  normal_ = across.normalized();
  x_ = Eigen::AngleAxisd(kAskew, normal_) * (corners[1] - corners[0]).normalized();
  y_ = normal_.cross(x_);
  for (std::size_t i = 0; i < 3; ++i) corners_[i] = onFace(corners[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 edge = (corners_[(i + 1) % 3] - corners_[i]).normalized();
    sides_[i].normal = Point2(edge.y(), -edge.x());
    sides_[i].offset = sides_[i].normal.dot(corners_[i]);
  }
}

Point2 FacePrism::onFace(const Point3& point) const {
  const Point3 from_origin = point - origin_;
  return {from_origin.dot(x_), from_origin.dot(y_)};
}

Box3 FacePrism::box(double depth_mm, double margin_mm) const {
  Box3 box;
  const Point3 wider = Point3::Constant(margin_mm + kOnFace);
  for (const Point3& corner : in_space_)
    for (const Point3& level : {corner, Point3(corner - depth_mm * normal_)}) {
      box.include(level - wider);
      box.include(level + wider);
    }
  return box;
}

std::optional<Band> FacePrism::band(const StraightBead& piece, const Imprint& imprint) const {
  Share share;
  const double start_height = (piece.start - origin_).dot(normal_);
  const double end_height = (piece.end - origin_).dot(normal_);
  share.keepBelow(start_height, end_height, kOnFace);
  share.keepBelow(-start_height, -end_height, imprint.depth_mm);
  if (share.isEmpty()) return std::nullopt;
  const Point2 start = onFace(piece.start);
  const Point2 end = onFace(piece.end);
  for (const HalfPlane& side : sides_)
    share.keepBelow(side.normal.dot(start), side.normal.dot(end), side.offset + imprint.margin_mm);
  if (share.isEmpty()) return std::nullopt;
  Band band;
  band.radius = imprint.radius_mm;
  band.start = start + share.from * (end - start);
  band.end = start + share.to * (end - start);
  const Point2 direction = end - start;
  const auto projected = [&](const Point3& vector) { return Point2(vector.dot(x_), vector.dot(y_)); };
  if (share.from == 0.0) {
    band.from_before = bisector(projected(piece.before), direction, start);
    band.from_before.normal *= -1.0;
    band.from_before.offset *= -1.0;
  }
  if (share.to == 1.0) band.to_after = bisector(direction, projected(piece.after), end);
  if (imprint.beyond_mm == 0.0 || direction.norm() < kLeastDirection) return band;
  const Point2 beyond = imprint.beyond_mm * direction.normalized();
  if (share.from == 0.0) band.start -= beyond;
  if (share.to == 1.0) band.end += beyond;
  return band;
}

HalfPlane bisector(const Point2& direction, const Point2& next, const Point2& joint) {
  HalfPlane half;
  const double length = direction.norm();
  const double next_length = next.norm();
  if (length < kLeastDirection || next_length < kLeastDirection) return half;
  if (direction.dot(next) < kSharpestJoint * length * next_length) return half;
  half.normal = direction / length + next / next_length;
  half.offset = half.normal.dot(joint);
  return half;
}

}  // namespace lamina
