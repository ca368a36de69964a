// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "loft.hpp"
#include "shapes.hpp"

namespace lamina {
namespace {

std::vector<Point3> squareRing(double side_mm, double z_mm) {
  const double half = 0.5 * side_mm;
  return {{-half, -half, z_mm}, {half, -half, z_mm}, {half, half, z_mm}, {-half, half, z_mm}};
}

std::vector<Point3> roundRing(double radius_mm, int segments, double z_mm) {
  std::vector<Point3> ring;
  ring.reserve(static_cast<std::size_t>(segments));
  for (int i = 0; i < segments; ++i) {
    const double angle = 2.0 * M_PI * i / segments;
    ring.emplace_back(radius_mm * std::cos(angle), radius_mm * std::sin(angle), z_mm);
  }
  return ring;
}

/// Solids that do not touch, as one mesh.
void append(Mesh& mesh, const Mesh& other, const Point3& by) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Point3& vertex : other.vertices) mesh.vertices.push_back(vertex + by);
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

/// A length and its key, for messages.
struct Named {
  const char* key;
  double mm;
};

void requireLess(const Named& smaller, const std::string& than, double limit_mm) {
  if (smaller.mm >= limit_mm)
    throw InvalidConfig(std::string(smaller.key) + " is " + numberText(smaller.mm) + "; must be less than " +
                        than + ", " + numberText(limit_mm));
}

}  // namespace

void describe(SettingsSchema& schema, SteppedPyramid& shape) {
  schema.number("width_mm", shape.width_mm, kLength, "side of the lowest square");
  schema.number("step_mm", shape.step_mm, kLength, "width of each step, on all sides");
  schema.number("step_height_mm", shape.step_height_mm, kLength, "height of each square");
  schema.integer("steps", shape.steps, {1.0, 1000.0}, "number of squares");
}

Mesh build(const SteppedPyramid& shape) {
  requireLess({"step_mm", shape.step_mm}, "half of width_mm over the steps above the lowest square",
              shape.steps > 1 ? 0.5 * shape.width_mm / (shape.steps - 1) : 2.0 * kLength.high);
  std::vector<std::vector<Point3>> rings;
  for (int i = 0; i < shape.steps; ++i)
    for (const int level : {i, i + 1})
      rings.push_back(squareRing(shape.width_mm - 2.0 * i * shape.step_mm, level * shape.step_height_mm));
  return loft(rings);
}

void describe(SettingsSchema& schema, Dome& shape) {
  schema.number("radius_mm", shape.radius_mm, kLength, "radius");
  schema.integer("segments", shape.segments, {8.0, 4000.0},
                 "flat segments around the foot, a quarter as many up");
}

/// Its top is a point.
Mesh build(const Dome& shape) {
  const int rings = shape.segments / 4;
  std::vector<std::vector<Point3>> all;
  for (int i = 0; i < rings; ++i) {
    const double rise = 0.5 * M_PI * i / rings;
    all.push_back(
        roundRing(shape.radius_mm * std::cos(rise), shape.segments, shape.radius_mm * std::sin(rise)));
  }
  Mesh mesh = loft(all);
  // The cap's strips would be needles: a vertex on the axis closes it.
  const auto count = static_cast<std::uint32_t>(shape.segments);
  mesh.triangles.resize(mesh.triangles.size() - (count - 2));
  const auto top = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(0.0, 0.0, shape.radius_mm);
  for (std::uint32_t i = 0; i < count; ++i)
    mesh.triangles.push_back({top - count + i, top - count + (i + 1) % count, top});
  return mesh;
}

void describe(SettingsSchema& schema, ConeArray& shape) {
  schema.number("foot_radius_mm", shape.foot_radius_mm, kLength, "radius of each foot");
  schema.number("height_mm", shape.height_mm, kLength, "height");
  schema.number("least_deg", shape.least_deg, {0.0, 85.0}, "lean of the first one's side from the vertical");
  schema.number("greatest_deg", shape.greatest_deg, {0.0, 85.0}, "lean of the last one's");
  schema.integer("count", shape.count, {1.0, 100.0}, "number of cones");
  schema.number("gap_mm", shape.gap_mm, kLength, "distance of neighbouring tops");
  schema.integer("segments", shape.segments, kSegments, "flat segments around each circle");
}

Mesh build(const ConeArray& shape) {
  if (shape.least_deg > shape.greatest_deg)
    throw InvalidConfig("least_deg is " + numberText(shape.least_deg) + "; must be at most greatest_deg, " +
                        numberText(shape.greatest_deg));
  Mesh mesh;
  double at_mm = -shape.gap_mm;
  for (int i = 0; i < shape.count; ++i) {
    const double share = shape.count > 1 ? static_cast<double>(i) / (shape.count - 1) : 0.0;
    const double lean = toRadians(shape.least_deg + share * (shape.greatest_deg - shape.least_deg));
    const double top_mm = shape.foot_radius_mm + shape.height_mm * std::tan(lean);
    at_mm += shape.gap_mm + top_mm;
    append(mesh,
           loft({roundRing(shape.foot_radius_mm, shape.segments, 0.0),
                 roundRing(top_mm, shape.segments, shape.height_mm)}),
           {at_mm, 0.0, 0.0});
    at_mm += top_mm;
  }
  for (Point3& vertex : mesh.vertices) vertex.x() -= 0.5 * at_mm;
  return mesh;
}

void describe(SettingsSchema& schema, PillarField& shape) {
  schema.number("pin_mm", shape.pin_mm, kLength, "diameter of each pin");
  schema.number("pitch_mm", shape.pitch_mm, kLength, "distance of neighbouring axes");
  schema.number("height_mm", shape.height_mm, kLength, "height");
  schema.integer("count", shape.count, {1.0, 100.0}, "number of pins along each side");
  schema.integer("segments", shape.segments, kSegments, "flat segments around each pin");
}

Mesh build(const PillarField& shape) {
  requireLess({"pin_mm", shape.pin_mm}, "pitch_mm", shape.pitch_mm);
  const Mesh pin = loft({roundRing(0.5 * shape.pin_mm, shape.segments, 0.0),
                         roundRing(0.5 * shape.pin_mm, shape.segments, shape.height_mm)});
  Mesh mesh;
  const double middle = 0.5 * (shape.count - 1);
  for (int row = 0; row < shape.count; ++row)
    for (int column = 0; column < shape.count; ++column)
      append(mesh, pin, {(column - middle) * shape.pitch_mm, (row - middle) * shape.pitch_mm, 0.0});
  return mesh;
}

void describe(SettingsSchema& schema, UChannel& shape) {
  schema.number("size_mm", shape.size_mm, kLength, "size along x and y");
  schema.number("notch_mm", shape.notch_mm, kLength, "width of the notch");
  schema.number("depth_mm", shape.depth_mm, kLength, "depth of the notch, from y behind");
  schema.number("height_mm", shape.height_mm, kLength, "height");
}

Mesh build(const UChannel& shape) {
  requireLess({"notch_mm", shape.notch_mm}, "size_mm", shape.size_mm);
  requireLess({"depth_mm", shape.depth_mm}, "size_mm", shape.size_mm);
  const double inner = 0.5 * shape.notch_mm;
  const double outer = 0.5 * shape.size_mm;
  const double end = outer - shape.depth_mm;
  return prism({{inner, outer},
                {inner, end},
                {-inner, end},
                {-inner, outer},
                {-outer, outer},
                {-outer, -outer},
                {outer, -outer},
                {outer, outer}},
               shape.height_mm);
}

void describe(SettingsSchema& schema, TwoTowers& shape) {
  schema.number("width_mm", shape.width_mm, kLength, "size of each along x and y");
  schema.number("gap_mm", shape.gap_mm, kLength, "distance between them");
  schema.number("height_mm", shape.height_mm, kLength, "height");
}

Mesh build(const TwoTowers& shape) {
  const Mesh tower = loft({squareRing(shape.width_mm, 0.0), squareRing(shape.width_mm, shape.height_mm)});
  const double aside = 0.5 * (shape.gap_mm + shape.width_mm);
  Mesh mesh;
  for (const double x : {-aside, aside}) append(mesh, tower, {x, 0.0, 0.0});
  return mesh;
}

void describe(SettingsSchema& schema, RoofNiche& shape) {
  schema.number("size_mm", shape.size_mm, kLength, "size of the block along each axis");
  schema.number("width_mm", shape.width_mm, kLength, "width of the niche");
  schema.number("depth_mm", shape.depth_mm, kLength, "depth of the niche");
  schema.number("floor_mm", shape.floor_mm, kLength, "height of the niche's floor");
  schema.number("height_mm", shape.height_mm, kLength, "height of the niche");
}

/// A loft towards the niche: the face beside it, and then its inside.
Mesh build(const RoofNiche& shape) {
  requireLess({"width_mm", shape.width_mm}, "size_mm", shape.size_mm);
  requireLess({"depth_mm", shape.depth_mm}, "size_mm", shape.size_mm);
  requireLess({"height_mm", shape.height_mm}, "what size_mm leaves above floor_mm",
              shape.size_mm - shape.floor_mm);
  const double half = 0.5 * shape.size_mm;
  const auto ring = [](double aside, double low, double high, double x) {
    return std::vector<Point3>{{x, -aside, low}, {x, aside, low}, {x, aside, high}, {x, -aside, high}};
  };
  const double aside = 0.5 * shape.width_mm;
  const double roof = shape.floor_mm + shape.height_mm;
  return loft({ring(half, 0.0, shape.size_mm, -half), ring(half, 0.0, shape.size_mm, half),
               ring(aside, shape.floor_mm, roof, half),
               ring(aside, shape.floor_mm, roof, half - shape.depth_mm)});
}

void describe(SettingsSchema& schema, ThinRoof& shape) {
  schema.number("size_mm", shape.size_mm, kLength, "size of the cube");
  schema.number("wall_mm", shape.wall_mm, kLength, "thickness of the cube's sides");
  schema.number("roof_mm", shape.roof_mm, kLength, "thickness of the roof at half height");
}

Mesh build(const ThinRoof& shape) {
  requireLess({"wall_mm", shape.wall_mm}, "half of size_mm", 0.5 * shape.size_mm);
  const double inside = shape.size_mm - 2.0 * shape.wall_mm;
  requireLess({"roof_mm", shape.roof_mm}, "size_mm without both sides", inside);
  const double height = 0.5 * (inside - shape.roof_mm);
  // A loft downwards faces inwards.
  const Mesh hollow = loft({squareRing(inside, height), squareRing(inside, 0.0)});
  Mesh mesh = loft({squareRing(shape.size_mm, 0.0), squareRing(shape.size_mm, shape.size_mm)});
  append(mesh, hollow, {0.0, 0.0, shape.wall_mm});
  append(mesh, hollow, {0.0, 0.0, shape.wall_mm + height + shape.roof_mm});
  return mesh;
}

}  // namespace lamina
