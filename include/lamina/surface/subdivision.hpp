// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh.hpp"

namespace lamina {

/// The same surface with no edge longer than `longest_edge_mm`: longer edges are halved, those of neighbours
/// at the same places, until none is left. The vertices of the mesh keep their numbers, new ones follow.
/// Closed meshes stay closed.
///
/// @throws InvalidInput if the length is not positive, or more than 20 million triangles would result
Mesh subdivided(const Mesh& mesh, double longest_edge_mm);

}  // namespace lamina
