// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/layer_ground.hpp"

#include <algorithm>

namespace lamina {

double widestBead(const LayerCells& cells) {
  return cells.size() == 0 ? 0.0 : *std::max_element(cells.width_mm.begin(), cells.width_mm.end());
}

Box3 groundOf(const LayerCells& cells, const Eigen::Vector3d& normal) {
  Box3 ground;
  const double reach = widestBead(cells);
  const Point3 around(reach, reach, reach);
  for (const Point3& middle : cells.middle) {
    const Point3 at = middle - middle.dot(normal) * normal;
    ground.include(at - around);
    ground.include(at + around);
  }
  return ground;
}

}  // namespace lamina
