// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh_repair.hpp"

namespace lamina {

// Each step takes a mesh and, if it needs it, the topology of that mesh.

/// A mesh after one step of repair, and what the step changed.
struct RepairStep {
  Mesh mesh;
  std::vector<RepairChange> changes;
};

/// Drops triangles that have a vertex twice. Their edges cancel each other, so that no hole opens.
RepairStep dropDegenerateTriangles(Mesh mesh);

/// Drops repeated triangles with the same corners in the same cyclic order, except the first.
RepairStep dropRepeatedTriangles(Mesh mesh, const MeshTopology& topology);

/// If every triangle also occurs with the opposite orientation, keeps the first of each two.
RepairStep dropBackOfDoubledSurface(Mesh mesh);

/// Merges border vertices that are nearer to each other than the tolerance [mm].
RepairStep stitchBorders(Mesh mesh, const MeshTopology& topology, double tolerance);

/// Splits triangles at border vertices that lie on their border edges within the tolerance [mm].
RepairStep splitAtBorderVertices(Mesh mesh, const MeshTopology& topology, double tolerance);

/// Turns triangles over so that neighbours run in opposite directions along their common edge; as few as
/// possible in each connected patch.
RepairStep orientConsistently(Mesh mesh, const MeshTopology& topology);

/// Closes every border loop by new triangles between its vertices.
RepairStep fillHoles(Mesh mesh, const MeshTopology& topology);

/// Drops bodies without volume and turns bodies that face inwards. The mesh must have no border.
RepairStep turnOutwards(Mesh mesh, const MeshTopology& topology);

/// The middle of a triangle.
Point3 middleOf(const Mesh& mesh, const Triangle& triangle);

}  // namespace lamina
