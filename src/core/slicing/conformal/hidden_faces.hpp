// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"

namespace lamina {

/// How much of a face lies open to what comes straight from a direction.
enum class Sight : std::uint8_t { Open, Partial, Hidden };

/// Which faces have other faces of the mesh before them, seen from far off in a direction: of each face, rays
/// from its middle, its corners and the middles of its sides, all drawn in by a thousandth. A face within
/// overlapping bodies is hidden by that of the outer one.
///
/// @param faces      of the mesh, none without area
/// @param direction  of unit length; from the mesh to where it is seen from
/// @return for each of the faces; n log n in the faces of the mesh where few lie over each other
std::vector<Sight> sightOf(const Mesh& mesh, const TriangleNumbers& faces, const Point3& direction);

}  // namespace lamina
