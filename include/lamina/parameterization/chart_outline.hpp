// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// The borders of a chart in its parameterization [mm]: the outer one counter-clockwise, those of holes
/// clockwise, each through every vertex of the border. They start where the chart's lowest half-edge of each
/// does.
std::vector<Polygon> outlineOf(const LayerChart& chart);

/// Borders of any parameterization of a mesh, on the left of which the triangles lie.
std::vector<Polygon> outlineOf(const Mesh& surface, const std::vector<Point2>& parameterization);

}  // namespace lamina
