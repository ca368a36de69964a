// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "loft.hpp"
#include "shapes.hpp"

namespace lamina {
namespace {

/// Half the thickness at the fraction x of the chord, 1 at the thickest: the four-digit NACA distribution,
/// and a trailing edge wide enough to be printed.
double halfThickness(double x) {
  constexpr double kThickest = 0.5002;
  constexpr double kTrailingEdge = 0.2;
  const double naca =
      1.4845 * std::sqrt(x) - 0.63 * x - 1.758 * x * x + 1.4215 * x * x * x - 0.518 * x * x * x * x;
  return (1.0 - kTrailingEdge * x) * naca / kThickest + kTrailingEdge * x;
}

/// From the trailing edge over the upper side to the leading edge and back below: counter-clockwise.
Polygon aerofoil(const Blade& shape) {
  const int half = shape.points / 2;
  const auto point_at = [&](int i, double side) {
    // Closer points towards the leading edge, where the curvature is.
    const double x = 0.5 * (1.0 + std::cos(M_PI * i / half));
    const double middle = shape.camber_mm * 4.0 * x * (1.0 - x);
    return Point2((x - 0.5) * shape.chord_mm, middle + side * 0.5 * shape.thickness_mm * halfThickness(x));
  };
  Polygon outline;
  for (int i = 0; i < half; ++i) outline.push_back(point_at(i, 1.0));
  outline.emplace_back(-0.5 * shape.chord_mm, 0.0);
  for (int i = half - 1; i >= 0; --i) outline.push_back(point_at(i, -1.0));
  return outline;
}

}  // namespace

void describe(SettingsSchema& schema, Blade& shape) {
  schema.number("chord_mm", shape.chord_mm, kLength, "length of the section from leading to trailing edge");
  schema.number("thickness_mm", shape.thickness_mm, kLength, "greatest thickness of the section");
  schema.number("camber_mm", shape.camber_mm, {0.0, 10000.0}, "rise of the section's middle line");
  schema.number("height_mm", shape.height_mm, kLength, "height");
  schema.number("twist_deg", shape.twist_deg, {-360.0, 360.0}, "turn of the top against the bottom");
  schema.number("lean_deg", shape.lean_deg, {-60.0, 60.0}, "lean of the blade's axis towards +y");
  schema.integer("points", shape.points, {8.0, 10000.0}, "points around the section");
  schema.integer("sections", shape.sections, {1.0, 10000.0}, "sections over the height");
}

Mesh build(const Blade& shape) {
  if (shape.thickness_mm > 0.5 * shape.chord_mm)
    throw InvalidConfig("thickness_mm is " + numberText(shape.thickness_mm) +
                        "; must be at most half of chord_mm, " + numberText(0.5 * shape.chord_mm));
  const Polygon outline = aerofoil(shape);
  std::vector<std::vector<Point3>> rings;
  for (int i = 0; i <= shape.sections; ++i) {
    // Measured from mid-height, so that the part stays in the middle of its box.
    const double fraction = static_cast<double>(i) / shape.sections - 0.5;
    const Eigen::Rotation2Dd turn(toRadians(fraction * shape.twist_deg));
    const double shift = fraction * shape.height_mm * std::tan(toRadians(shape.lean_deg));
    std::vector<Point3> ring;
    for (const Point2& point : outline) {
      const Point2 turned = turn * point;
      ring.emplace_back(turned.x(), turned.y() + shift, (fraction + 0.5) * shape.height_mm);
    }
    rings.push_back(std::move(ring));
  }
  return loft(rings);
}

}  // namespace lamina
