// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/skin_parts.hpp"

#include <algorithm>
#include <array>

#include "geometry/mesh/area_vector.hpp"
#include "slicing/volumetric/skin_samples.hpp"

namespace lamina {
namespace {

constexpr double kFlat = 0.9998;  // cosine between normals of one flat face

bool isSamePart(const SkinPart& a, const SkinPart& b) {
  return a.node == b.node && a.normal.dot(b.normal) > kFlat;
}

bool isBefore(const SkinPart& a, const SkinPart& b) { return a.node < b.node; }

}  // namespace

std::pair<const SkinPart*, const SkinPart*> partsAt(const std::vector<SkinPart>& parts, std::uint32_t node) {
  const auto [first, last] = std::equal_range(parts.begin(), parts.end(), SkinPart{node}, isBefore);
  return {parts.data() + (first - parts.begin()), parts.data() + (last - parts.begin())};
}

std::vector<SkinPart> skinParts(const Mesh& mesh, const CellGraph& cells, Progress& progress) {
  std::vector<SkinPart> parts;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 4096 == 0) throwIfCancelled(progress, "fit");
    const Point3 normal = triangleNormal(mesh, i);
    std::array<Point3, 3> corner;
    for (std::size_t side = 0; side < 3; ++side) corner[side] = mesh.vertices[mesh.triangles[i][side]];
    visitParts(corner, cells.frame().voxel_mm, [&](const auto&, const Point3& place, double) {
      const SkinPart part{nodeBelow(cells, place, normal), i, normal};
      if (part.node != CellGraph::kNone && (parts.empty() || !isSamePart(part, parts.back())))
        parts.push_back(part);
    });
  }
  std::stable_sort(parts.begin(), parts.end(), isBefore);
  parts.erase(std::unique(parts.begin(), parts.end(), isSamePart), parts.end());
  std::vector<SkinPart> all = parts;
  for (const SkinPart& part : parts)
    for (const std::uint32_t near : cells.links(part.node)) {
      const auto [first, last] = partsAt(parts, near);
      if (first == last && part.normal.dot(cells.middle(near) - cells.middle(part.node)) > 0.0)
        all.push_back({near, part.triangle, part.normal});
    }
  std::stable_sort(all.begin(), all.end(), isBefore);
  return all;
}

}  // namespace lamina
