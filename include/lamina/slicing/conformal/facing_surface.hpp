// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/curved/vertex_motion.hpp"

namespace lamina {

/// Which way a surface of a part faces.
enum class Facing { Down, Up };

/// Triangles of a mesh by number, in ascending order.
using TriangleNumbers = std::vector<std::uint32_t>;

/// The triangles that face down (n_z < -limit) or up (n_z > limit) in patches that hang together across
/// common vertices, the patch with the lowest (greatestHeight) place of them all first, the others in the
/// order of their first triangles. Triangles without area belong to none. ([Guacheta2021, listing A.5], with
/// the signed rule.) Empty if nothing faces that way.
std::vector<TriangleNumbers> facingPatches(const Mesh& mesh, Facing facing, double normal_limit);

/// The triangles of a mesh that are in neither of two ascending lists.
TriangleNumbers remainder(const Mesh& mesh, const TriangleNumbers& lower, const TriangleNumbers& upper);

/// Triangles by number as a mesh of its own, without the vertices they do not use.
Mesh patchOf(const Mesh& mesh, const TriangleNumbers& triangles);

/// The same surface seen from its other side.
Mesh turnedOver(Mesh mesh);

/// A patch with the faces beside its rim as walls: all those of the mesh that share a vertex with it.
ShellSource shellSourceOf(const Mesh& mesh, const TriangleNumbers& triangles);

/// The greatest height that triangles of the mesh come to [mm]; that upside down, negated, if the sign is -1.
double greatestHeight(const Mesh& mesh, const TriangleNumbers& triangles, double sign);

}  // namespace lamina
