// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/parameterization/flattening_settings.hpp"

namespace lamina {

/// Lays a surface out flat with little change of lengths: a place in the parameter plane [mm] for each
/// vertex. By area, more triangles wind counter-clockwise than clockwise, but single triangles may be flipped
/// or overlap (`measureDistortion` and `isInjective` check this). Position and rotation of the
/// parameterization are arbitrary.
///
/// @param surface  [mm] connected by edges, with any borders and holes
/// @throws InvalidMesh if triangles do not connect a vertex with the others
std::vector<Point2> flatten(const Mesh& surface, const FlatteningSettings& settings);

}  // namespace lamina
