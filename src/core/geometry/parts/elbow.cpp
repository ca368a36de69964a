// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "loft.hpp"
#include "shapes.hpp"

namespace lamina {
namespace {

/// A circle across a direction in the xz plane that leans by an angle from up towards +x.
std::vector<Point3> ringAcross(double lean, const Point3& middle, const Elbow& shape) {
  const Point3 aside(std::cos(lean), 0.0, -std::sin(lean));
  std::vector<Point3> ring;
  for (int i = 0; i < shape.segments; ++i) {
    const double angle = 2.0 * M_PI * i / shape.segments;
    ring.push_back(middle + shape.radius_mm * (std::cos(angle) * aside + std::sin(angle) * Point3::UnitY()));
  }
  return ring;
}

}  // namespace

void describe(SettingsSchema& schema, Elbow& shape) {
  schema.number("radius_mm", shape.radius_mm, kLength, "radius of the rod");
  schema.number("bend_radius_mm", shape.bend_radius_mm, kLength, "radius of the bend of its middle");
  schema.number("angle_deg", shape.angle_deg, Bounds::above(0.0, 120.0), "angle that it bends over");
  schema.number("foot_mm", shape.foot_mm, kLength, "height of the upright piece");
  schema.integer("segments", shape.segments, kSegments, "flat segments around the rod");
}

Mesh build(const Elbow& shape) {
  if (shape.bend_radius_mm <= shape.radius_mm)
    throw InvalidConfig("bend_radius_mm is " + numberText(shape.bend_radius_mm) +
                        "; must be more than radius_mm, " + numberText(shape.radius_mm));
  const double bend = shape.bend_radius_mm;
  const int rings = 1 + shape.segments / 2;
  std::vector<std::vector<Point3>> along = {ringAcross(0.0, Point3::Zero(), shape)};
  for (int i = 0; i <= rings; ++i) {
    const double lean = toRadians(shape.angle_deg) * i / rings;
    const Point3 middle(bend * (1.0 - std::cos(lean)), 0.0, shape.foot_mm + bend * std::sin(lean));
    along.push_back(ringAcross(lean, middle, shape));
  }
  return loft(along);
}

}  // namespace lamina
