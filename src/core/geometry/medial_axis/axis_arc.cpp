// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/medial_axis/axis_arc.hpp"

#include <cmath>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// Halvings of an arc at most: enough for 1e-5 mm on 10 m, and an end to whatever rounding does.
constexpr int kDeepest = 24;

/// The parabola of a focus and a line, over the line.
class Parabola {
 public:
  Parabola(const ArcSite& line, const Point2& focus)
      : origin_(line.from), along_((line.to - line.from).normalized()) {
    const double side = line.signedDistanceTo(focus);
    up_ = side < 0.0 ? rightOf(along_) : leftOf(along_);
    focus_at_ = along_.dot(focus - origin_);
    focus_height_ = std::abs(side);
  }

  bool isFlat() const { return !(focus_height_ > 0.0); }
  double positionOf(const Point2& point) const { return along_.dot(point - origin_); }
  Point2 at(double position) const {
    const double aside = position - focus_at_;
    const double height = (aside * aside + focus_height_ * focus_height_) / (2.0 * focus_height_);
    return origin_ + position * along_ + height * up_;
  }

 private:
  Point2 origin_;
  Point2 along_;
  Point2 up_;
  double focus_at_ = 0.0;
  double focus_height_ = 0.0;
};

/// Halves a piece of the arc until its middle is near enough to that of its ends.
/// @param middle  of two points of the arc
template <class Middle>
void halve(std::vector<AxisPoint>& points, const AxisPoint& to, const Middle& middle, double tolerance,
           int depth) {
  const AxisPoint from = points.back();
  const AxisPoint half = middle(from.point, to.point);
  const double bend = (half.point - 0.5 * (from.point + to.point)).norm();
  const double swell = std::abs(half.radius_mm - 0.5 * (from.radius_mm + to.radius_mm));
  if (depth < kDeepest && std::max(bend, swell) > tolerance) {
    halve(points, half, middle, tolerance, depth + 1);
    halve(points, to, middle, tolerance, depth + 1);
  } else {
    points.push_back(to);
  }
}

}  // namespace

double ArcSite::signedDistanceTo(const Point2& point) const {
  if (!is_segment) return (point - from).norm();
  return cross((to - from).normalized(), point - from);
}

double ArcSite::distanceTo(const Point2& point) const { return std::abs(signedDistanceTo(point)); }

std::vector<AxisPoint> AxisArc::sampled(const Point2& from, const Point2& to, double tolerance) const {
  const ArcSite& nearest = first.is_segment ? second : first;
  const auto ended = [&](const Point2& point) { return AxisPoint{point, nearest.distanceTo(point)}; };
  std::vector<AxisPoint> points = {ended(from)};
  if (first.is_segment && second.is_segment) {
    points.push_back(ended(to));
    return points;
  }
  if (first.is_segment || second.is_segment) {
    const Parabola parabola(first.is_segment ? first : second, nearest.from);
    const auto middle = [&](const Point2& a, const Point2& b) {
      return ended(parabola.isFlat() ? Point2(0.5 * (a + b))
                                     : parabola.at(0.5 * (parabola.positionOf(a) + parabola.positionOf(b))));
    };
    halve(points, ended(to), middle, tolerance, 0);
  } else {
    const auto middle = [&](const Point2& a, const Point2& b) { return ended(0.5 * (a + b)); };
    halve(points, ended(to), middle, tolerance, 0);
  }
  return points;
}

}  // namespace lamina
