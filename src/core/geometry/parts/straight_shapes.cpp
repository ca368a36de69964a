// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "loft.hpp"
#include "shapes.hpp"

namespace lamina {
namespace {

Polygon rectangle(double x, double y) {
  return {{-0.5 * x, -0.5 * y}, {0.5 * x, -0.5 * y}, {0.5 * x, 0.5 * y}, {-0.5 * x, 0.5 * y}};
}

/// A prism along y, in the middle over y = 0; its outline stands upright, in x and z.
Mesh standingPrism(const Polygon& outline, double width_mm) {
  Mesh mesh = prism(outline, width_mm);
  for (Point3& vertex : mesh.vertices) vertex = {vertex.x(), 0.5 * width_mm - vertex.z(), vertex.y()};
  return mesh;
}

/// The permutations of (0, ±1, ±2).
std::vector<Point3> truncatedOctahedronVertices() {
  std::vector<Point3> vertices;
  for (int zero = 0; zero < 3; ++zero)
    for (int order = 1; order <= 2; ++order)
      for (const double one : {-1.0, 1.0})
        for (const double two : {-2.0, 2.0}) {
          Point3 vertex = Point3::Zero();
          vertex[(zero + order) % 3] = one;
          vertex[(zero + 3 - order) % 3] = two;
          vertices.push_back(vertex);
        }
  return vertices;
}

/// The face of a convex solid about the origin that lies farthest along the normal, as a fan.
void addFace(Mesh& mesh, const Point3& normal) {
  double farthest = 0.0;
  for (const Point3& vertex : mesh.vertices) farthest = std::max(farthest, normal.dot(vertex));
  std::vector<std::uint32_t> face;
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
    if (normal.dot(mesh.vertices[i]) > farthest - 1e-9) face.push_back(i);
  const Point3 x_axis = normal.unitOrthogonal();
  const Point3 y_axis = normal.cross(x_axis);
  const auto angle = [&](std::uint32_t i) {
    return std::atan2(y_axis.dot(mesh.vertices[i]), x_axis.dot(mesh.vertices[i]));
  };
  std::sort(face.begin(), face.end(), [&](std::uint32_t a, std::uint32_t b) { return angle(a) < angle(b); });
  for (std::size_t i = 2; i < face.size(); ++i) mesh.triangles.push_back({face[0], face[i - 1], face[i]});
}

}  // namespace

void describe(SettingsSchema& schema, CuboidShape& shape) {
  schema.number("x_mm", shape.x_mm, kLength, "size along x");
  schema.number("y_mm", shape.y_mm, kLength, "size along y");
  schema.number("z_mm", shape.z_mm, kLength, "size along z");
}

Mesh build(const CuboidShape& shape) { return prism(rectangle(shape.x_mm, shape.y_mm), shape.z_mm); }

void describe(SettingsSchema& schema, FlatWall& shape) {
  schema.number("length_mm", shape.length_mm, kLength, "size along x");
  schema.number("thickness_mm", shape.thickness_mm, kLength, "size along y");
  schema.number("height_mm", shape.height_mm, kLength, "size along z");
}

Mesh build(const FlatWall& shape) {
  return prism(rectangle(shape.length_mm, shape.thickness_mm), shape.height_mm);
}

void describe(SettingsSchema& schema, Pyramid& shape) {
  schema.number("width_mm", shape.width_mm, kLength, "size of the base along x");
  schema.number("depth_mm", shape.depth_mm, kLength, "size of the base along y");
  schema.number("height_mm", shape.height_mm, kLength, "height of the tip");
}

Mesh build(const Pyramid& shape) {
  return pyramidOver(rectangle(shape.width_mm, shape.depth_mm), {0.0, 0.0, shape.height_mm});
}

void describe(SettingsSchema& schema, BridgeShape& shape) {
  schema.number("length_mm", shape.length_mm, kLength, "size along x");
  schema.number("width_mm", shape.width_mm, kLength, "size along y");
  schema.number("gap_mm", shape.gap_mm, kLength, "distance of the pillars");
  schema.number("pillar_mm", shape.pillar_mm, kLength, "height of the pillars");
  schema.number("plate_mm", shape.plate_mm, kLength, "thickness of the plate");
}

Mesh build(const BridgeShape& shape) {
  if (shape.gap_mm >= shape.length_mm)
    throw InvalidConfig("gap_mm is " + numberText(shape.gap_mm) + "; must be less than length_mm, " +
                        numberText(shape.length_mm));
  const double inner = 0.5 * shape.gap_mm;
  const double outer = 0.5 * shape.length_mm;
  const double top = shape.pillar_mm + shape.plate_mm;
  return standingPrism({{-inner, 0.0},
                        {-inner, shape.pillar_mm},
                        {inner, shape.pillar_mm},
                        {inner, 0.0},
                        {outer, 0.0},
                        {outer, top},
                        {-outer, top},
                        {-outer, 0.0}},
                       shape.width_mm);
}

void describe(SettingsSchema& schema, TeeShape& shape) {
  schema.number("stem_mm", shape.stem_mm, kLength, "size of the stem along x");
  schema.number("stem_height_mm", shape.stem_height_mm, kLength, "height of the stem");
  schema.number("bar_mm", shape.bar_mm, kLength, "size of the bar along x");
  schema.number("bar_height_mm", shape.bar_height_mm, kLength, "height of the bar");
  schema.number("width_mm", shape.width_mm, kLength, "size along y");
}

Mesh build(const TeeShape& shape) {
  if (shape.stem_mm >= shape.bar_mm)
    throw InvalidConfig("stem_mm is " + numberText(shape.stem_mm) + "; must be less than bar_mm, " +
                        numberText(shape.bar_mm));
  const double stem = 0.5 * shape.stem_mm;
  const double bar = 0.5 * shape.bar_mm;
  const double under = shape.stem_height_mm;
  const double top = under + shape.bar_height_mm;
  // Corners within the top let `loft` close the sides by triangles with an area.
  return standingPrism({{bar, top},
                        {stem, top},
                        {stem / 3.0, top},
                        {-stem / 3.0, top},
                        {-2.0 * stem / 3.0, top},
                        {-bar, top},
                        {-bar, under},
                        {-stem, under},
                        {-stem, 0.0},
                        {stem, 0.0},
                        {stem, under},
                        {bar, under}},
                       shape.width_mm);
}

void describe(SettingsSchema& schema, Tetradecahedron& shape) {
  schema.number("edge_mm", shape.edge_mm, kLength, "length of each edge");
}

Mesh build(const Tetradecahedron& shape) {
  Mesh mesh;
  mesh.vertices = truncatedOctahedronVertices();
  for (const double sign : {-1.0, 1.0})
    for (int axis = 0; axis < 3; ++axis) addFace(mesh, sign * Point3::Unit(axis));
  for (int octant = 0; octant < 8; ++octant) {
    const auto sign = [&](int bit) { return (octant >> bit & 1) != 0 ? 1.0 : -1.0; };
    addFace(mesh, Point3(sign(0), sign(1), sign(2)).normalized());
  }
  // Edges of the permutations are sqrt(2) long, and the bottom face lies at z = -2.
  for (Point3& vertex : mesh.vertices)
    vertex = (vertex + Point3(0.0, 0.0, 2.0)) * (shape.edge_mm / std::sqrt(2.0));
  return mesh;
}

void describe(SettingsSchema& schema, BevelledCube& shape) {
  schema.number("size_mm", shape.size_mm, kLength, "size along each axis");
}

Mesh build(const BevelledCube& shape) {
  const double edge = shape.size_mm * (std::sqrt(2.0) - 1.0);
  const double bevel = 0.5 * (shape.size_mm - edge);
  const auto ring = [](double side, double z) {
    std::vector<Point3> points;
    for (const Point2& point : rectangle(side, side)) points.emplace_back(point.x(), point.y(), z);
    return points;
  };
  return loft({ring(edge, 0.0), ring(shape.size_mm, bevel), ring(shape.size_mm, shape.size_mm - bevel),
               ring(edge, shape.size_mm)});
}

}  // namespace lamina
