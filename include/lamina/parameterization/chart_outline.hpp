// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// The borders of a chart in its parameterization [mm]: the outer one counter-clockwise, those of holes
/// clockwise, each through every vertex of the border. Each border starts where its half-edge of the lowest
/// number does.
std::vector<Polygon> outlineOf(const LayerChart& chart);

/// The borders of any parameterization of a mesh, with the triangles on their left.
std::vector<Polygon> outlineOf(const Mesh& surface, const std::vector<Point2>& parameterization);

}  // namespace lamina
