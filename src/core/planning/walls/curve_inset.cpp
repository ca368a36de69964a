// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/curve_inset.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lamina/geometry/polygon/polygon.hpp"
#include "slicing/adapted/curve_places.hpp"
#include "slicing/adapted/plan_crossings.hpp"

namespace lamina {
namespace {

constexpr double kCoincident = 1e-9;  // mm
constexpr double kNearEnough = 0.95;  // of the distance: normals of points beside each other differ

void append(AdaptedCurve& curve, const AdaptedCurve& source, std::size_t i) {
  curve.points.push_back(source.points[i]);
  curve.axis.push_back(source.axis[i]);
  curve.height_mm.push_back(source.height_mm[i]);
}

/// The way along the curve from one point to another seen by the first one's tool, across its axis.
Point3 wayAcross(const AdaptedCurve& curve, std::size_t at, std::size_t from, std::size_t to) {
  const Point3 way = curve.points[to] - curve.points[from];
  return way - way.dot(curve.axis[at]) * curve.axis[at];
}

/// From a point of the curve to that of the moved one.
Point3 inward(const AdaptedCurve& curve, std::size_t i, double distance_mm) {
  const std::size_t count = curve.points.size();
  const std::size_t before = i > 0 ? i - 1 : (curve.is_closed ? count - 1 : 0);
  const std::size_t after = i + 1 < count ? i + 1 : (curve.is_closed ? 0 : i);
  Point3 arriving = wayAcross(curve, i, before, i);
  Point3 leaving = wayAcross(curve, i, i, after);
  if (arriving.norm() <= kCoincident) arriving = leaving;
  if (leaving.norm() <= kCoincident) leaving = arriving;
  const double shorter_mm = std::min(arriving.norm(), leaving.norm());
  const Point3 tangent = arriving.normalized() + leaving.normalized();
  if (tangent.norm() <= kCoincident) return Point3::Zero();
  const double cosine = 0.5 * tangent.norm();  // of half the turn
  // A corner moves along its segments, but not past their other ends.
  const double mitre = std::min(1.0 / cosine, std::hypot(1.0, shorter_mm / distance_mm));
  return distance_mm * mitre * curve.axis[i].cross(tangent).normalized();
}

AdaptedCurve moved(const AdaptedCurve& curve, double distance_mm, InsetWay way) {
  AdaptedCurve result = curve;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Point3 move = inward(curve, i, distance_mm);
    const double level = move.head<2>().squaredNorm();
    if (way == InsetWay::AcrossWall || level == 0.0)
      result.points[i] += move;
    else
      result.points[i].head<2>() += move.squaredNorm() / level * move.head<2>();
  }
  return result;
}

double areaOf(const AdaptedCurve& curve) {
  Polygon plan;
  for (const Point3& point : curve.points) plan.emplace_back(point.head<2>());
  return signedArea(plan);
}

/// Of the two loops of a crossing that which leaves out what lies between the crossed segments.
AdaptedCurve aroundCrossing(const AdaptedCurve& curve, const PlanCrossing& crossing,
                            const AdaptedCurve& cut) {
  AdaptedCurve piece;
  piece.is_closed = curve.is_closed;
  for (std::size_t i = 0; i <= crossing.first.segment; ++i) append(piece, curve, i);
  append(piece, cut, 0);
  for (std::size_t i = crossing.second.segment + 1; i < curve.points.size(); ++i) append(piece, curve, i);
  return piece;
}

AdaptedCurve insideCrossing(const AdaptedCurve& curve, const PlanCrossing& crossing,
                            const AdaptedCurve& cut) {
  AdaptedCurve piece;
  append(piece, cut, 0);
  for (std::size_t i = crossing.first.segment + 1; i <= crossing.second.segment; ++i) append(piece, curve, i);
  return piece;
}

/// Simple loops of which the curve consists; of an open one also the rest.
std::vector<AdaptedCurve> cutAtCrossings(AdaptedCurve curve) {
  std::vector<AdaptedCurve> open;
  open.push_back(std::move(curve));
  std::vector<AdaptedCurve> simple;
  while (!open.empty()) {
    const std::vector<AdaptedCurve> one{std::move(open.back())};
    open.pop_back();
    const std::vector<PlanCrossing> crossings = planCrossings(one);
    if (crossings.empty()) {
      simple.push_back(one.front());
      continue;
    }
    // The innermost, so that the piece inside is simple or nearly so.
    const auto innermost = std::min_element(
        crossings.begin(), crossings.end(), [](const PlanCrossing& a, const PlanCrossing& b) {
          return a.second.segment - a.first.segment < b.second.segment - b.first.segment;
        });
    const AdaptedCurve cut = pointAt(one, *innermost);
    open.push_back(insideCrossing(one.front(), *innermost, cut));
    open.push_back(aroundCrossing(one.front(), *innermost, cut));
  }
  return simple;
}

/// Whether a loop encloses anything, and on the side of the curve that it was cut from.
bool isLoopOf(const AdaptedCurve& piece, const AdaptedCurve& curve, double distance_mm) {
  const double area = areaOf(piece);
  return area * areaOf(curve) > 0.0 && std::abs(area) >= distance_mm * distance_mm;
}

/// Whether most of the points are as far from the wall as they should be.
bool isInside(const AdaptedCurve& piece, const CurvePlaces& wall, double distance_mm) {
  const auto far = std::count_if(piece.points.begin(), piece.points.end(), [&](const Point3& point) {
    return wall.nearest(point).distance_mm >= kNearEnough * distance_mm;
  });
  return piece.points.size() >= (piece.is_closed ? 3U : 2U) &&
         2 * static_cast<std::size_t>(far) > piece.points.size();
}

}  // namespace

std::vector<AdaptedCurve> insetCurve(const AdaptedCurve& curve, double distance_mm, InsetWay way) {
  if (distance_mm == 0.0) return {curve};
  const CurvePlaces wall(curve.points, curve.is_closed);
  std::vector<AdaptedCurve> inside;
  for (AdaptedCurve& piece : cutAtCrossings(moved(curve, distance_mm, way)))
    if (piece.is_closed == curve.is_closed && isInside(piece, wall, distance_mm) &&
        (!piece.is_closed || isLoopOf(piece, curve, distance_mm)))
      inside.push_back(std::move(piece));
  return inside;
}

}  // namespace lamina
