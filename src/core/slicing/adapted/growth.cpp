// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/growth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slicing/adapted/point_order.hpp"

namespace lamina {
namespace {

constexpr double kGrowthRounding = 1e-9;  // of a height, so that vertical walls keep their own points
constexpr int kMostRounds = 12;           // in which the place stood on becomes the nearest one
constexpr double kSettled = 1e-5;         // of a height: the point moves no more

/// The upper of the points of the line from `low` to `high` at a distance from a point; if the line passes it
/// farther away, the point at that distance nearest to the line.
Point3 onLineAt(const Point3& low, const Point3& high, const Point3& from, double distance) {
  const Point3 along = (high - low).normalized();
  const Point3 foot = low + (from - low).dot(along) * along;
  const double across = (foot - from).norm();
  if (across >= distance) return from + distance / across * (foot - from);
  return foot + std::sqrt(distance * distance - across * across) * along;
}

}  // namespace

PlacedCurve::PlacedCurve(AdaptedCurve placed)
    : curve(std::move(placed)), places(curve.points, curve.is_closed), length(curve) {}

AdaptedCurve curveThrough(const std::vector<GrownPoint>& grown, bool is_closed, const PlacedCurve& below) {
  std::vector<double> feet_mm;
  feet_mm.reserve(grown.size());
  for (const GrownPoint& point : grown) feet_mm.push_back(point.foot_mm);
  AdaptedCurve curve;
  curve.is_closed = is_closed;
  for (const std::size_t i : pointsInOrder(feet_mm, below.curve.is_closed ? below.length.total() : 0.0)) {
    curve.points.push_back(grown[i].point);
    curve.axis.push_back(grown[i].axis);
    curve.height_mm.push_back(grown[i].height_mm);
  }
  return curve;
}

Growth::Growth(const WallStrand& strand) : strand_(strand) {
  for (const WallContour& contour : strand.levels) {
    heights_.push_back(contour.points.front().z());
    places_.push_back(std::make_unique<CurvePlaces>(contour.points, true));
  }
}

std::size_t Growth::firstAbove(double z) const {
  return static_cast<std::size_t>(std::upper_bound(heights_.begin(), heights_.end(), z) - heights_.begin());
}

void Growth::putOnWall(GrownPoint& grown, std::size_t above, const PlacedCurve& below) const {
  const CurvePlace foot = below.places.nearest(grown.point);
  grown.foot_mm = below.length.at(foot);
  const CurvePlace high = places_[above]->nearest(grown.point);
  const CurvePlace low = places_[above - 1]->nearest(high.point);
  grown.point = onLineAt(low.point, high.point, foot.point, grown.height_mm);
  grown.axis =
      (directionAt(strand_.levels[above].axis, high) + directionAt(below.curve.axis, foot)).normalized();
}

void Growth::returnToWall(GrownPoint& grown, std::size_t level, double foot_z,
                          const PlacedCurve& below) const {
  // Levels higher than the point can be would all be gone through without effect on where it ends.
  std::size_t above = std::min(level, firstAbove(foot_z + grown.height_mm));
  for (; above > 1 && grown.point.z() < heights_[above - 1]; --above) putOnWall(grown, above, below);
  for (int round = 0; round < kMostRounds; ++round) {
    const Point3 before = grown.point;
    putOnWall(grown, above, below);
    if ((grown.point - before).norm() < kSettled * grown.height_mm) break;
  }
}

GrownPoint Growth::towards(std::size_t level, std::size_t i, const PlacedCurve& below,
                           double height_mm) const {
  const WallContour& contour = strand_.levels[level];
  const Point3& wanted = contour.points[i];
  const CurvePlace foot = below.places.nearest(wanted);
  if (foot.distance_mm <= height_mm * (1.0 + kGrowthRounding))
    return {wanted, contour.axis[i], foot.distance_mm, below.length.at(foot), true};
  const Point3 foot_axis = directionAt(below.curve.axis, foot);
  GrownPoint grown;
  grown.point = foot.point + height_mm / foot.distance_mm * (wanted - foot.point);
  grown.axis = (contour.axis[i] + foot_axis).normalized();
  grown.height_mm = height_mm;
  returnToWall(grown, level, foot.point.z(), below);
  return grown;
}

}  // namespace lamina
