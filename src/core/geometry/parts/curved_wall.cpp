// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "loft.hpp"
#include "shapes.hpp"

namespace lamina {

void describe(SettingsSchema& schema, CurvedWall& shape) {
  schema.number("radius_mm", shape.radius_mm, kLength, "radius of the middle of the wall");
  schema.number("angle_deg", shape.angle_deg, Bounds::above(0.0, 350.0), "angle that the wall goes round");
  schema.number("thickness_mm", shape.thickness_mm, kLength, "thickness");
  schema.number("height_mm", shape.height_mm, kLength, "height");
  schema.integer("segments", shape.segments, kSegments, "flat segments along the wall");
}

Mesh build(const CurvedWall& shape) {
  if (0.5 * shape.thickness_mm >= shape.radius_mm)
    throw InvalidConfig("thickness_mm is " + numberText(shape.thickness_mm) +
                        "; must be less than twice radius_mm, " + numberText(2.0 * shape.radius_mm));
  const double start = toRadians(-0.5 * shape.angle_deg);
  const auto point_at = [&](double radius, int i) {
    const double angle = start * (1.0 - 2.0 * i / shape.segments);
    return Point2(radius * std::cos(angle) - shape.radius_mm, radius * std::sin(angle));
  };
  Polygon outline;
  for (int i = 0; i <= shape.segments; ++i)
    outline.push_back(point_at(shape.radius_mm + 0.5 * shape.thickness_mm, i));
  for (int i = shape.segments; i >= 0; --i)
    outline.push_back(point_at(shape.radius_mm - 0.5 * shape.thickness_mm, i));
  return prism(outline, shape.height_mm);
}

}  // namespace lamina
