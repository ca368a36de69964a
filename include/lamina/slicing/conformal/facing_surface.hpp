// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/curved/vertex_motion.hpp"

namespace lamina {

/// Whether a surface faces down or up.
enum class Facing { Down, Up };

/// Indices of triangles of a mesh, in ascending order.
using TriangleNumbers = std::vector<std::uint32_t>;

/// The triangles that face down (n_z < -limit) or up (n_z > limit), in patches connected by common vertices
/// ([Guacheta2021, listing A.5], with the sign of n_z). The first patch contains the lowest point of all
/// patches (facing down) or the highest (facing up); the others follow in the order of their first triangles.
/// Triangles without area belong to no patch. Empty if no triangle faces in the direction asked for.
std::vector<TriangleNumbers> facingPatches(const Mesh& mesh, Facing facing, double normal_limit);

/// The triangles of a mesh that are in neither of two lists.
TriangleNumbers remainder(const Mesh& mesh, const TriangleNumbers& lower, const TriangleNumbers& upper);

/// The mesh of these triangles alone, without unused vertices.
Mesh patchOf(const Mesh& mesh, const TriangleNumbers& triangles);

/// The mesh with the orientation of every triangle reversed.
Mesh turnedOver(Mesh mesh);

/// A patch as the source of shells. Its walls are all other faces of the mesh that share a vertex with it.
ShellSource shellSourceOf(const Mesh& mesh, const TriangleNumbers& triangles);

/// The greatest value of sign * z among the vertices of the triangles [mm].
/// @param sign  1 for the greatest height; -1 for the least height, negated
double greatestHeight(const Mesh& mesh, const TriangleNumbers& triangles, double sign);

}  // namespace lamina
