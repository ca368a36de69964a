// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loft.hpp"

namespace lamina {
namespace {

enum class Facing { Up, Down };

void addCap(Mesh& mesh, std::uint32_t first, std::uint32_t count, Facing facing) {
  std::uint32_t low = 0;
  std::uint32_t high = count - 1;
  for (bool takes_low = true; low + 1 < high; takes_low = !takes_low) {
    const std::uint32_t next = takes_low ? low + 1 : high - 1;
    Triangle triangle = {first + low, first + next, first + high};
    if (facing == Facing::Down) std::swap(triangle[1], triangle[2]);
    mesh.triangles.push_back(triangle);
    (takes_low ? low : high) = next;
  }
}

void addLoftBand(Mesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    mesh.triangles.push_back({lower + i, lower + j, upper + j});
    mesh.triangles.push_back({lower + i, upper + j, upper + i});
  }
}

std::vector<Point3> ringAt(const Polygon& outline, double z) {
  std::vector<Point3> ring;
  for (const Point2& point : outline) ring.emplace_back(point.x(), point.y(), z);
  return ring;
}

}  // namespace

Mesh loft(const std::vector<std::vector<Point3>>& rings) {
  Mesh mesh;
  const auto count = static_cast<std::uint32_t>(rings.front().size());
  for (const auto& ring : rings) mesh.vertices.insert(mesh.vertices.end(), ring.begin(), ring.end());
  const auto last = static_cast<std::uint32_t>(rings.size() - 1) * count;
  addCap(mesh, 0, count, Facing::Down);
  for (std::uint32_t lower = 0; lower < last; lower += count) addLoftBand(mesh, lower, lower + count, count);
  addCap(mesh, last, count, Facing::Up);
  return mesh;
}

Mesh prism(const Polygon& outline, double height) {
  return loft({ringAt(outline, 0.0), ringAt(outline, height)});
}

Mesh pyramidOver(const Polygon& outline, const Point3& apex) {
  Mesh mesh;
  mesh.vertices = ringAt(outline, 0.0);
  const auto count = static_cast<std::uint32_t>(outline.size());
  addCap(mesh, 0, count, Facing::Down);
  mesh.vertices.push_back(apex);
  for (std::uint32_t i = 0; i < count; ++i) mesh.triangles.push_back({i, (i + 1) % count, count});
  return mesh;
}

}  // namespace lamina
