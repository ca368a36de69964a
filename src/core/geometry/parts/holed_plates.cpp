// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "shapes.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kCorners = 4;

/// A rectangle's corners and a circle about its middle at one height, as vertices of a mesh.
struct Level {
  std::uint32_t corners;
  std::uint32_t circle;
};

struct Outline {
  double x;
  double y;
  double radius;
  std::uint32_t segments;
};

void requireRoom(const Outline& outline) {
  if (2.0 * outline.radius >= std::min(outline.x, outline.y))
    throw InvalidConfig("hole_radius_mm is " + numberText(outline.radius) +
                        "; must be less than half of x_mm and y_mm, " +
                        numberText(0.5 * std::min(outline.x, outline.y)));
  if (outline.segments % kCorners != 0)
    throw InvalidConfig("segments is " + std::to_string(outline.segments) + "; must be a multiple of 4");
}

std::uint32_t addCorners(Mesh& mesh, const Outline& outline, double z) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const auto& [x, y] :
       {std::pair(0.5, 0.5), std::pair(-0.5, 0.5), std::pair(-0.5, -0.5), std::pair(0.5, -0.5)})
    mesh.vertices.emplace_back(x * outline.x, y * outline.y, z);
  return first;
}

std::uint32_t addCircle(Mesh& mesh, const Outline& outline, double z) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t i = 0; i < outline.segments; ++i) {
    const double angle = 2.0 * M_PI * i / outline.segments;
    mesh.vertices.emplace_back(outline.radius * std::cos(angle), outline.radius * std::sin(angle), z);
  }
  return first;
}

void addTurned(Mesh& mesh, const Triangle& t, bool is_turned) {
  mesh.triangles.push_back(is_turned ? Triangle{t[0], t[2], t[1]} : t);
}

/// The face between rectangle and circle. A corner sees the whole of its quarter of the circle.
void addRing(Mesh& mesh, const Level& level, std::uint32_t segments, bool faces_down) {
  const std::uint32_t quarter = segments / kCorners;
  for (std::uint32_t corner = 0; corner < kCorners; ++corner) {
    const std::uint32_t own = level.corners + corner;
    for (std::uint32_t i = corner * quarter; i < (corner + 1) * quarter; ++i)
      addTurned(mesh, {own, level.circle + (i + 1) % segments, level.circle + i}, faces_down);
    const std::uint32_t next = level.corners + (corner + 1) % kCorners;
    addTurned(mesh, {own, next, level.circle + (corner + 1) * quarter % segments}, faces_down);
  }
}

void addBand(Mesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t count, bool faces_inwards) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    addTurned(mesh, {lower + i, lower + j, upper + j}, faces_inwards);
    addTurned(mesh, {lower + i, upper + j, upper + i}, faces_inwards);
  }
}

void addFan(Mesh& mesh, std::uint32_t first, std::uint32_t count, bool faces_down) {
  for (std::uint32_t i = 2; i < count; ++i) addTurned(mesh, {first, first + i - 1, first + i}, faces_down);
}

}  // namespace

void describe(SettingsSchema& schema, ThroughHolePlate& shape) {
  schema.number("x_mm", shape.x_mm, kLength, "size along x");
  schema.number("y_mm", shape.y_mm, kLength, "size along y");
  schema.number("z_mm", shape.z_mm, kLength, "size along z");
  schema.number("hole_radius_mm", shape.hole_radius_mm, kLength, "radius of the hole");
  schema.integer("segments", shape.segments, {4.0, 100000.0},
                 "flat segments around the hole, a multiple of 4");
}

Mesh build(const ThroughHolePlate& shape) {
  const Outline outline = {shape.x_mm, shape.y_mm, shape.hole_radius_mm,
                           static_cast<std::uint32_t>(shape.segments)};
  requireRoom(outline);
  Mesh mesh;
  const Level bottom = {addCorners(mesh, outline, 0.0), addCircle(mesh, outline, 0.0)};
  const Level top = {addCorners(mesh, outline, shape.z_mm), addCircle(mesh, outline, shape.z_mm)};
  addRing(mesh, bottom, outline.segments, true);
  addBand(mesh, bottom.corners, top.corners, kCorners, false);
  addBand(mesh, bottom.circle, top.circle, outline.segments, true);
  addRing(mesh, top, outline.segments, false);
  return mesh;
}

void describe(SettingsSchema& schema, BlindHolePlate& shape) {
  schema.number("x_mm", shape.x_mm, kLength, "size along x");
  schema.number("y_mm", shape.y_mm, kLength, "size along y");
  schema.number("z_mm", shape.z_mm, kLength, "size along z");
  schema.number("hole_radius_mm", shape.hole_radius_mm, kLength, "radius of the hole");
  schema.number("hole_depth_mm", shape.hole_depth_mm, kLength, "depth of the hole from the top");
  schema.integer("segments", shape.segments, {4.0, 100000.0},
                 "flat segments around the hole, a multiple of 4");
}

Mesh build(const BlindHolePlate& shape) {
  const Outline outline = {shape.x_mm, shape.y_mm, shape.hole_radius_mm,
                           static_cast<std::uint32_t>(shape.segments)};
  requireRoom(outline);
  if (shape.hole_depth_mm >= shape.z_mm)
    throw InvalidConfig("hole_depth_mm is " + numberText(shape.hole_depth_mm) + "; must be less than z_mm, " +
                        numberText(shape.z_mm));
  Mesh mesh;
  const std::uint32_t bottom = addCorners(mesh, outline, 0.0);
  const std::uint32_t floor = addCircle(mesh, outline, shape.z_mm - shape.hole_depth_mm);
  const Level top = {addCorners(mesh, outline, shape.z_mm), addCircle(mesh, outline, shape.z_mm)};
  addFan(mesh, bottom, kCorners, true);
  addBand(mesh, bottom, top.corners, kCorners, false);
  addFan(mesh, floor, outline.segments, false);
  addBand(mesh, floor, top.circle, outline.segments, true);
  addRing(mesh, top, outline.segments, false);
  return mesh;
}

}  // namespace lamina
