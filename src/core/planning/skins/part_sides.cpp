// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skins/part_sides.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>

#include "geometry/boxes.hpp"

namespace lamina {
namespace {

constexpr double kTouchingMm = 1e-9;  // from a triangle's plane: on either side of it

Box3 boxOf(const Mesh& mesh, const Triangle& corners) {
  Box3 box;
  for (const std::uint32_t corner : corners) box.include(mesh.vertices[corner]);
  return box;
}

std::vector<Box3> boxesOf(const Mesh& mesh) {
  std::vector<Box3> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const Triangle& corners : mesh.triangles) boxes.push_back(boxOf(mesh, corners));
  return boxes;
}

Box3 boxAbout(const Point3& from, const Point3& to) {
  Box3 box;
  box.include(from);
  box.include(to);
  box.low.array() -= kTouchingMm;
  box.high.array() += kTouchingMm;
  return box;
}

}  // namespace

PartSides::PartSides(const Mesh& mesh) : mesh_(mesh), inside_(mesh), boxes_(boxesOf(mesh)) {}

bool PartSides::mayMeet(std::size_t triangle, const Point3& from, const Point3& to) const {
  const Triangle& corners = mesh_.triangles[triangle];
  const Point3& a = mesh_.vertices[corners[0]];
  const Point3 normal = (mesh_.vertices[corners[1]] - a).cross(mesh_.vertices[corners[2]] - a);
  const double touching = kTouchingMm * normal.norm();
  const double first = normal.dot(from - a);
  const double second = normal.dot(to - a);
  return std::min(first, second) <= touching && std::max(first, second) >= -touching;
}

bool PartSides::isClearBetween(const Point3& from, const Point3& to) const {
  bool is_clear = true;
  boxes_.visitOverlapping(boxAbout(from, to), [&](std::uint32_t triangle) {
    is_clear = is_clear && !mayMeet(triangle, from, to);
  });
  return is_clear;
}

bool RowSides::isWithin(const Point3& place, std::size_t row) {
  std::optional<Known>& last = last_[row];
  const bool is_near = last && (place - last->place).norm() <= near_mm_;
  if (is_near && part_.isClearBetween(last->place, place)) {
    last->place = place;
    return last->is_within;
  }
  ++solid_angles_;
  last = Known{place, part_.isWithin(place)};
  return last->is_within;
}

}  // namespace lamina
