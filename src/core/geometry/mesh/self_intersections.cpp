// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/self_intersections.hpp"

#include <algorithm>
#include <optional>

#include "geometry/mesh/triangle_crossing.hpp"
#include "geometry/spatial/box_tree.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostNamed = 10;

std::vector<Box3> boxesOf(const Mesh& mesh) {
  std::vector<Box3> boxes(mesh.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t]) boxes[t].include(mesh.vertices[v]);
  return boxes;
}

struct Range {
  std::uint32_t first;
  std::uint32_t last;
};

/// The intersections of a range of triangles with those after them.
SelfIntersections findInRange(const Mesh& mesh, const MeshTopology& topology, const BoxTree& tree,
                              Range range) {
  SelfIntersections found;
  for (std::uint32_t t = range.first; t < range.last; ++t) {
    tree.visitOverlapping(tree.box(t), [&](std::uint32_t other) {
      if (other <= t) return;
      const std::optional<Point3> point = findCrossing(mesh, topology, t, other);
      if (!point) return;
      if (found.pairs++ < kMostNamed) found.where.push_back(*point);
    });
  }
  return found;
}

}  // namespace

SelfIntersections findSelfIntersections(const Mesh& mesh, Progress& progress) {
  constexpr std::size_t kRange = 1024;
  const BoxTree tree(boxesOf(mesh));
  const std::size_t count = mesh.triangles.size();
  std::vector<SelfIntersections> ranges((count + kRange - 1) / kRange);
  const MeshTopology topology = pairHalfEdges(mesh);
  const auto find = [&](std::size_t i) {
    const Range range = {static_cast<std::uint32_t>(i * kRange),
                         static_cast<std::uint32_t>(std::min(count, (i + 1) * kRange))};
    ranges[i] = findInRange(mesh, topology, tree, range);
  };
  parallelFor(ranges.size(), find, progress, "intersect");
  SelfIntersections all;
  for (const SelfIntersections& range : ranges) {
    all.pairs += range.pairs;
    const std::size_t room = kMostNamed - all.where.size();
    all.where.insert(all.where.end(), range.where.begin(),
                     range.where.begin() + static_cast<std::ptrdiff_t>(std::min(room, range.where.size())));
  }
  return all;
}

}  // namespace lamina
