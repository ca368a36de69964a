// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "border_loops.hpp"

namespace lamina {
namespace {

/// The border half-edge that starts where `border` ends, on the same fan of triangles.
HalfEdge nextAlongBorder(const MeshTopology& topology, HalfEdge border) {
  HalfEdge next = nextInTriangle(border);
  while (topology.opposite[next] != kNoHalfEdge) next = nextInTriangle(topology.opposite[next]);
  return next;
}

}  // namespace

std::vector<std::vector<HalfEdge>> findBorderLoops(const MeshTopology& topology) {
  std::vector<std::vector<HalfEdge>> loops;
  if (!topology.has_border) return loops;
  std::vector<bool> is_chained(topology.opposite.size(), false);
  for (HalfEdge start = 0; start < topology.opposite.size(); ++start) {
    if (topology.opposite[start] != kNoHalfEdge || is_chained[start]) continue;
    std::vector<HalfEdge>& loop = loops.emplace_back();
    for (HalfEdge h = start; !is_chained[h]; h = nextAlongBorder(topology, h)) {
      is_chained[h] = true;
      loop.push_back(h);
    }
  }
  return loops;
}

}  // namespace lamina
