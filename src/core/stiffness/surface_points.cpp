// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/surface_points.hpp"

#include "stiffness/element_nodes.hpp"

namespace lamina {

SurfacePoints surfacePoints(const StiffnessResult& result) {
  const ElementLattice& lattice = result.model.lattice;
  const auto nodes = static_cast<std::size_t>(lattice.nodeCount());
  std::vector<unsigned char> around(nodes);
  std::vector<float> sum(nodes);
  std::size_t element = 0;
  forElements(lattice, [&](const ElementRun& run, std::int32_t i) {
    const float stress = result.stress[element++].vonMises();
    for (const std::int32_t node : nodesAround(run, i)) {
      ++around[static_cast<std::size_t>(node)];
      sum[static_cast<std::size_t>(node)] += stress;
    }
  });
  SurfacePoints points;
  forNodes(lattice, [&](std::int32_t number, int i, int j, int k) {
    const auto node = static_cast<std::size_t>(number);
    if (around[node] == 8) return;
    const auto& u = result.displacement.along;
    points.place.push_back(placeOf(result.model, i, j, k).cast<float>());
    points.displacement.push_back(Point3(u[0][node], u[1][node], u[2][node]).cast<float>());
    points.von_mises.push_back(sum[node] / static_cast<float>(around[node]));
  });
  return points;
}

}  // namespace lamina
