// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "geometry/parts/loft.hpp"
#include "geometry/parts/shapes.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

/// The vertices that one point of the outline sweeps: a ring, or one vertex on the axis.
struct Swept {
  std::uint32_t first;
  bool is_on_axis;

  std::uint32_t at(std::uint32_t segment) const { return is_on_axis ? first : first + segment; }
};

Swept sweep(Mesh& mesh, const Point2& point, int segments) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  if (point.x() == 0.0) {
    mesh.vertices.emplace_back(0.0, 0.0, point.y());
    return {first, true};
  }
  for (int i = 0; i < segments; ++i) {
    const double angle = 2.0 * M_PI * i / segments;
    mesh.vertices.emplace_back(point.x() * std::cos(angle), point.x() * std::sin(angle), point.y());
  }
  return {first, false};
}

void addTurnedBand(Mesh& mesh, const Swept& from, const Swept& to, int segments) {
  const auto count = static_cast<std::uint32_t>(segments);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    if (!from.is_on_axis) mesh.triangles.push_back({from.at(i), from.at(j), to.at(j)});
    if (!to.is_on_axis) mesh.triangles.push_back({from.at(i), to.at(j), to.at(i)});
  }
}

/// The solid of revolution about z of the area inside a counter-clockwise outline of (radius, z) points, in
/// `segments` flat segments. Points of radius 0 become one vertex on the axis; an outline may run along the
/// axis.
Mesh revolve(const Polygon& outline, int segments) {
  Mesh mesh;
  std::vector<Swept> swept;
  for (const Point2& point : outline) swept.push_back(sweep(mesh, point, segments));
  for (std::size_t i = 0; i < swept.size(); ++i) {
    const Swept& from = swept[i];
    const Swept& to = swept[(i + 1) % swept.size()];
    if (!(from.is_on_axis && to.is_on_axis)) addTurnedBand(mesh, from, to, segments);
  }
  return mesh;
}

constexpr const char* kSegmentsMeaning = "flat segments around the full circle";

}  // namespace

void describe(SettingsSchema& schema, Cylinder& shape) {
  schema.number("radius_mm", shape.radius_mm, kLength, "radius");
  schema.number("height_mm", shape.height_mm, kLength, "height");
  schema.integer("segments", shape.segments, kSegments, kSegmentsMeaning);
}

Mesh build(const Cylinder& shape) {
  return revolve(
      {{0.0, 0.0}, {shape.radius_mm, 0.0}, {shape.radius_mm, shape.height_mm}, {0.0, shape.height_mm}},
      shape.segments);
}

void describe(SettingsSchema& schema, Sphere& shape) {
  schema.number("radius_mm", shape.radius_mm, kLength, "radius");
  schema.integer("segments", shape.segments, {4.0, 4000.0},
                 "flat segments around the equator, half as many up");
}

Mesh build(const Sphere& shape) {
  const int rings = shape.segments / 2;
  Polygon outline = {{0.0, 0.0}};
  for (int i = 1; i < rings; ++i) {
    const double angle = M_PI * i / rings;
    outline.emplace_back(shape.radius_mm * std::sin(angle), shape.radius_mm * (1.0 - std::cos(angle)));
  }
  outline.emplace_back(0.0, 2.0 * shape.radius_mm);
  return revolve(outline, shape.segments);
}

void describe(SettingsSchema& schema, Cone& shape) {
  schema.number("radius_mm", shape.radius_mm, kLength, "radius of the base");
  schema.number("top_radius_mm", shape.top_radius_mm, {0.0, 10000.0}, "radius at the top; 0 gives a tip");
  schema.number("height_mm", shape.height_mm, kLength, "height");
  schema.integer("segments", shape.segments, kSegments, kSegmentsMeaning);
}

Mesh build(const Cone& shape) {
  Polygon outline = {{0.0, 0.0}, {shape.radius_mm, 0.0}};
  if (shape.top_radius_mm > 0.0) outline.emplace_back(shape.top_radius_mm, shape.height_mm);
  outline.emplace_back(0.0, shape.height_mm);
  return revolve(outline, shape.segments);
}

void describe(SettingsSchema& schema, Tube& shape) {
  schema.number("radius_mm", shape.radius_mm, kLength, "outer radius");
  schema.number("inner_radius_mm", shape.inner_radius_mm, kLength, "inner radius");
  schema.number("height_mm", shape.height_mm, kLength, "height");
  schema.integer("segments", shape.segments, kSegments, kSegmentsMeaning);
}

Mesh build(const Tube& shape) {
  if (shape.inner_radius_mm >= shape.radius_mm)
    throw InvalidConfig("inner_radius_mm is " + numberText(shape.inner_radius_mm) +
                        "; must be less than radius_mm, " + numberText(shape.radius_mm));
  return revolve({{shape.inner_radius_mm, 0.0},
                  {shape.radius_mm, 0.0},
                  {shape.radius_mm, shape.height_mm},
                  {shape.inner_radius_mm, shape.height_mm}},
                 shape.segments);
}

void describe(SettingsSchema& schema, Flare& shape) {
  schema.number("radius_mm", shape.radius_mm, kLength, "radius of the foot");
  schema.number("height_mm", shape.height_mm, kLength, "height");
  schema.number("lean_deg", shape.lean_deg, Bounds::above(0.0, 80.0), "lean of the side at the top");
  schema.integer("segments", shape.segments, kSegments, kSegmentsMeaning);
}

Mesh build(const Flare& shape) {
  constexpr int kSteps = 48;  // of the arc
  const double arc_mm = shape.height_mm / std::sin(toRadians(shape.lean_deg));
  Polygon outline = {{0.0, 0.0}};
  for (int i = 0; i <= kSteps; ++i) {
    const double lean = toRadians(shape.lean_deg) * i / kSteps;
    outline.emplace_back(shape.radius_mm + arc_mm * (1.0 - std::cos(lean)), arc_mm * std::sin(lean));
  }
  outline.emplace_back(0.0, outline.back().y());
  return revolve(outline, shape.segments);
}

void describe(SettingsSchema& schema, SemiCone& shape) {
  schema.number("radius_mm", shape.radius_mm, kLength, "radius of the base");
  schema.number("height_mm", shape.height_mm, kLength, "height of the tip");
  schema.integer("segments", shape.segments, {2.0, 100000.0}, "flat segments around the half circle");
}

Mesh build(const SemiCone& shape) {
  Polygon outline;
  for (int i = 0; i <= shape.segments; ++i) {
    const double angle = M_PI * i / shape.segments;
    outline.emplace_back(shape.radius_mm * std::cos(angle), shape.radius_mm * std::sin(angle));
  }
  outline.back().y() = 0.0;
  return pyramidOver(outline, {0.0, 0.0, shape.height_mm});
}

}  // namespace lamina
