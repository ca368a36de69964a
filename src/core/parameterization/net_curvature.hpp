// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// Gaussian curvature at each vertex [rad]: what the angles around it lack of a full turn; 0 on the border.
std::vector<double> insideCurvature(const Mesh& mesh, const MeshTopology& topology);

/// Gaussian curvature of a surface summed over its inside [rad]: what the angles around each vertex that is
/// not on the border lack of a full turn. A cap of a sphere that reaches t from its pole has 2 pi (1 - cos
/// t), whatever its mesh; a surface that unrolls has 0, a saddle less.
double netCurvature(const Mesh& mesh, const MeshTopology& topology);

/// The greatest net curvature [rad] with which a surface that is as round as a cap can lie flat with all
/// lengths true within a tolerance. Of all maps of a cap the azimuthal equidistant one stretches least, by t
/// / sin t [Milnor1969].
/// @param tolerance  relative, from 0 to less than 1; 0 gives 0
double greatestFlatCurvature(double tolerance);

}  // namespace lamina
