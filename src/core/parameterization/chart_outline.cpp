// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/chart_outline.hpp"

#include "geometry/mesh/border_loops.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

std::vector<Polygon> outlineOf(const Mesh& surface, const std::vector<Point2>& parameterization) {
  std::vector<Polygon> outlines;
  for (const std::vector<HalfEdge>& loop : findBorderLoops(pairHalfEdges(surface))) {
    Polygon& outline = outlines.emplace_back();
    outline.reserve(loop.size());
    for (const HalfEdge side : loop) outline.push_back(parameterization[originOf(surface, side)]);
  }
  return outlines;
}

std::vector<Polygon> outlineOf(const LayerChart& chart) {
  return outlineOf(chart.surface.middle, chart.parameterization);
}

}  // namespace lamina
