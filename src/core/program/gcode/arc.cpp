// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/arc.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kSameArcPoint = 1e-6;    // mm: below what programs resolve
constexpr double kRadiusRounding = 1e-3;  // mm: last decimal of programs
constexpr double kWidestStep = M_PI / 8;

Point2 inPlane(const Point3& point, int axis) { return {point[(axis + 1) % 3], point[(axis + 2) % 3]}; }

double angleOf(const Point2& point) { return std::atan2(point.y(), point.x()); }

/// Angle swept about the axis, signed.
double sweep(const Arc& arc, const Point2& from_centre, const Point2& to_centre) {
  const bool is_circle = (to_centre - from_centre).norm() < kSameArcPoint;
  const double sign = arc.direction == ArcDirection::CounterClockwise ? 1.0 : -1.0;
  double angle = sign * (angleOf(to_centre) - angleOf(from_centre));
  if (is_circle) return sign * 2.0 * M_PI;
  if (angle <= 0.0) angle += 2.0 * M_PI;
  return sign * angle;
}

}  // namespace

std::vector<Point3> flatten(const Arc& arc, double chord_tolerance_mm) {
  const Point2 centre = inPlane(arc.centre, arc.axis);
  const Point2 from = inPlane(arc.start, arc.axis) - centre;
  const Point2 to = inPlane(arc.end, arc.axis) - centre;
  const double radius = std::max(from.norm(), to.norm());
  const double angle = sweep(arc, from, to);
  const double step =
      std::min(kWidestStep, 2.0 * std::acos(std::max(0.0, 1.0 - chord_tolerance_mm / radius)));
  const auto count = static_cast<std::size_t>(std::ceil(std::abs(angle) / std::max(step, 1e-6)));

  std::vector<Point3> ends;
  ends.reserve(count + 1);
  for (std::size_t i = 1; i < count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count);
    const double r = from.norm() + part * (to.norm() - from.norm());
    const double a = angleOf(from) + part * angle;
    Point3 point;
    point[arc.axis] = arc.start[arc.axis] + part * (arc.end[arc.axis] - arc.start[arc.axis]);
    point[(arc.axis + 1) % 3] = centre.x() + r * std::cos(a);
    point[(arc.axis + 2) % 3] = centre.y() + r * std::sin(a);
    ends.push_back(point);
  }
  ends.push_back(arc.end);
  return ends;
}

Point3 centreOfRadius(const Arc& arc, double radius_mm) {
  const Point2 from = inPlane(arc.start, arc.axis);
  const Point2 chord = inPlane(arc.end, arc.axis) - from;
  const double half = 0.5 * chord.norm();
  if (half < kSameArcPoint)
    throw InvalidInput("an arc of given radius ends where it starts; its centre is not defined");
  if (half > std::abs(radius_mm) + kRadiusRounding)
    throw InvalidInput("an arc of radius " + numberText(std::abs(radius_mm)) + " mm cannot span " +
                       numberText(2.0 * half) + " mm");
  const double height = std::sqrt(std::max(0.0, radius_mm * radius_mm - half * half));
  const double side = (arc.direction == ArcDirection::CounterClockwise) == (radius_mm > 0.0) ? 1.0 : -1.0;
  const Point2 centre = from + 0.5 * chord + side * height / (2.0 * half) * leftOf(chord);
  Point3 placed = arc.start;
  placed[(arc.axis + 1) % 3] = centre.x();
  placed[(arc.axis + 2) % 3] = centre.y();
  return placed;
}

}  // namespace lamina
