// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// Gaussian curvature at each vertex [rad]: 2 pi less the sum of the angles around it; 0 on the border.
std::vector<double> insideCurvature(const Mesh& mesh, const MeshTopology& topology);

/// Total Gaussian curvature inside a surface [rad]: the sum, over all vertices not on the border, of 2 pi
/// less the angles around the vertex. A cap of a unit sphere that extends an angle t from its pole has 2 pi
/// (1 - cos t), whatever its mesh; a surface that unrolls has 0, a saddle less.
double netCurvature(const Mesh& mesh, const MeshTopology& topology);

/// The greatest net curvature [rad] with which a surface like a spherical cap can be laid flat with all
/// lengths true within a tolerance. Of all maps of a cap of angle t the azimuthal equidistant one stretches
/// least, by t / sin t [Milnor1969].
/// @param tolerance  relative, from 0 to less than 1; 0 gives 0
double greatestFlatCurvature(double tolerance);

}  // namespace lamina
