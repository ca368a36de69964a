// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/curves_between.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "slicing/adapted/curve_length.hpp"

namespace lamina {
namespace {

/// From one unit vector to another by a share of the angle between them.
Point3 turned(const Point3& from, const Point3& to, double share) {
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  const double sine = std::sin(angle);
  if (sine < 1e-9) return share < 0.5 ? from : to;
  return ((std::sin((1.0 - share) * angle) * from + std::sin(share * angle) * to) / sine).normalized();
}

/// The places of the lower curve that belong to the points of the upper one.
std::vector<CurvePlace> partners(const PlacedCurve& lower, const AdaptedCurve& upper) {
  const CurveLength& below = lower.length;
  const CurveLength above(upper);
  const double first = below.at(lower.places.nearest(upper.points.front()));
  double span = below.total();
  if (!upper.is_closed) {
    span = below.at(lower.places.nearest(upper.points.back())) - first;
    if (lower.curve.is_closed && span < 0.0) span += below.total();
  }
  std::vector<CurvePlace> places;
  places.reserve(upper.points.size());
  for (std::size_t i = 0; i < upper.points.size(); ++i)
    places.push_back(below.placeAt(first + span * above.atPoint(i) / above.total()));
  return places;
}

}  // namespace

std::vector<AdaptedCurve> curvesBetween(const PlacedCurve& lower, const AdaptedCurve& upper,
                                        std::size_t parts) {
  if (parts == 1) return {upper};
  const std::vector<CurvePlace> places = partners(lower, upper);
  std::vector<AdaptedCurve> curves;
  for (std::size_t part = 1; part <= parts; ++part) {
    const double share = static_cast<double>(part) / static_cast<double>(parts);
    AdaptedCurve curve = upper;
    for (double& height : curve.height_mm) height /= static_cast<double>(parts);
    for (std::size_t i = 0; i < places.size() && part < parts; ++i) {
      curve.points[i] = (1.0 - share) * places[i].point + share * upper.points[i];
      curve.axis[i] = turned(directionAt(lower.curve.axis, places[i]), upper.axis[i], share);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace lamina
