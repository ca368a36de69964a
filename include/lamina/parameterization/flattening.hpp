// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/parameterization/flattening_settings.hpp"

namespace lamina {

/// Lays a surface out flat with little change of lengths: a place in the parameter plane [mm] for each
/// vertex. More of the triangles' area winds counter-clockwise than clockwise; nothing is promised of single
/// triangles (`measureDistortion` and `isInjective` check them). The parameterization's place and direction
/// are arbitrary.
///
/// @param surface  [mm] connected by edges; borders and holes as they come
/// @throws InvalidMesh if a vertex hangs together with the others by no triangle
std::vector<Point2> flatten(const Mesh& surface, const FlatteningSettings& settings);

}  // namespace lamina
