// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A layer that need not be plane: an open mesh through the middle of what is deposited. Its triangles wind
/// counter-clockwise seen from the nozzle. The vectors hold one value per vertex.
struct LayerSurface {
  Mesh middle;                    ///< [mm, part frame]
  std::vector<Point3> tip;        ///< where the nozzle tip passes, at the top of the layer [mm, part frame]
  std::vector<Point3> normal;     ///< against the tool axis, of unit length [part frame]
  std::vector<double> height_mm;  ///< thickness of the layer along the normal
};

/// A piece of a layer and its parameterization: the same triangles in space and in the plane.
struct LayerChart {
  LayerSurface surface;
  /// Of each vertex [mm]; triangles wind counter-clockwise and do not overlap.
  std::vector<Point2> parameterization;
};

}  // namespace lamina
