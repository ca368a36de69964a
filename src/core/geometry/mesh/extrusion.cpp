// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/extrusion.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

#include "lamina/geometry/polygon/region_triangulation.hpp"

namespace lamina {
namespace {

/// Points of the border in the order in which their outlines run.
std::vector<std::uint32_t> inOrder(const std::vector<OutlinePlace>& border) {
  std::vector<std::uint32_t> order(border.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const OutlinePlace& one = border[a];
    const OutlinePlace& other = border[b];
    return std::tie(one.outline, one.segment, one.fraction) <
           std::tie(other.outline, other.segment, other.fraction);
  });
  return order;
}

/// Two triangles between neighbours of the border, below and above.
void addWall(Mesh& mesh, std::uint32_t from, std::uint32_t to, std::uint32_t top) {
  mesh.triangles.push_back({from, to, to + top});
  mesh.triangles.push_back({from, to + top, from + top});
}

void addWalls(Mesh& mesh, const std::vector<OutlinePlace>& border, std::uint32_t base, std::uint32_t top) {
  const std::vector<std::uint32_t> order = inOrder(border);
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && border[order[end]].outline == border[order[begin]].outline) ++end;
    for (std::size_t i = begin; i < end; ++i)
      addWall(mesh, base + order[i], base + order[i + 1 < end ? i + 1 : begin], top);
    begin = end;
  }
}

void addPrism(Mesh& mesh, const Region& region, double height_mm) {
  const std::vector<Polygon> borders = outlines({region});
  const double step_mm = 4.0 * boundingBox(borders).size().norm();
  const RegionTriangulation flat = triangulated(borders, step_mm);
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto top = static_cast<std::uint32_t>(flat.points.size());
  for (const double z : {0.0, height_mm})
    for (const Point2& point : flat.points) mesh.vertices.emplace_back(point.x(), point.y(), z);
  for (const Triangle& t : flat.triangles) {
    mesh.triangles.push_back({base + t[0], base + t[2], base + t[1]});
    mesh.triangles.push_back({base + top + t[0], base + top + t[1], base + top + t[2]});
  }
  addWalls(mesh, flat.border, base, top);
}

}  // namespace

Mesh extruded(const Regions& regions, double height_mm) {
  Mesh mesh;
  for (const Region& region : regions) addPrism(mesh, region, height_mm);
  return mesh;
}

}  // namespace lamina
