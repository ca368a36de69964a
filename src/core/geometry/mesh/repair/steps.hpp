// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh_repair.hpp"

namespace lamina {

// Each step takes the mesh and, where it asks for it, the topology of that mesh.

/// A mesh after one step of repair, and what the step changed.
struct RepairStep {
  Mesh mesh;
  std::vector<RepairChange> changes;
};

/// Drops triangles that name a vertex twice. They close nothing: each of their edges runs there and back.
RepairStep dropDegenerateTriangles(Mesh mesh);

/// Of triangles with the same corners in the same turning sense, keeps the first.
RepairStep dropRepeatedTriangles(Mesh mesh, const MeshTopology& topology);

/// If every triangle also stands the other way round, keeps the first of each two.
RepairStep dropBackOfDoubledSurface(Mesh mesh);

/// Makes border vertices nearer than the tolerance [mm] one.
RepairStep stitchBorders(Mesh mesh, const MeshTopology& topology, double tolerance);

/// Splits triangles at border vertices that lie on their border edges within the tolerance [mm].
RepairStep splitAtBorderVertices(Mesh mesh, const MeshTopology& topology, double tolerance);

/// Turns triangles so that neighbours run opposite ways along their common edge; the fewer of a connected
/// patch.
RepairStep orientConsistently(Mesh mesh, const MeshTopology& topology);

/// Closes every border loop by new triangles between its vertices.
RepairStep fillHoles(Mesh mesh, const MeshTopology& topology);

/// Drops bodies without volume and turns bodies that face inwards. The mesh must have no border.
RepairStep turnOutwards(Mesh mesh, const MeshTopology& topology);

/// The middle of a triangle.
Point3 middleOf(const Mesh& mesh, const Triangle& triangle);

}  // namespace lamina
