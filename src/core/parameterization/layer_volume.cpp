// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/layer_volume.hpp"

#include <Eigen/Geometry>

namespace lamina {

double volume(const LayerSurface& layer) {
  double sum = 0.0;
  for (const Triangle& corner : layer.middle.triangles) {
    const Point3& a = layer.middle.vertices[corner[0]];
    const double area =
        0.5 * (layer.middle.vertices[corner[1]] - a).cross(layer.middle.vertices[corner[2]] - a).norm();
    sum +=
        area * (layer.height_mm[corner[0]] + layer.height_mm[corner[1]] + layer.height_mm[corner[2]]) / 3.0;
  }
  return sum;
}

double volume(const std::vector<LayerSurface>& layers) {
  double sum = 0.0;
  for (const LayerSurface& layer : layers) sum += volume(layer);
  return sum;
}

}  // namespace lamina
