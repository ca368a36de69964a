// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// Changes of one kind that a repair has made: their number, and the place of the first (of a hole, its
/// middle).
struct RepairChange {
  std::string what;  ///< "degenerate triangles dropped"
  std::size_t count = 0;
  Point3 where = Point3::Zero();  ///< [mm, part frame]
};

/// "8 degenerate triangles dropped near (1.5, 2, 0.3) mm"
std::string toText(const RepairChange& change);

/// Limits of what a repair may change.
struct RepairSettings {
  /// Border vertices that are nearer to each other than this become one [mm]; limited to 1e-4 of the diagonal
  /// of the mesh.
  double stitch_tolerance_mm = 0.01;
};

/// A mesh that encloses a solid: each edge has equally many half-edges in both directions, no triangle has
/// the same vertex twice, and every body faces outwards, except that a body inside another may face inwards,
/// as a cavity.
struct RepairResult {
  Mesh mesh;
  MeshTopology topology;              ///< of `mesh`; without border
  std::vector<RepairChange> changes;  ///< empty if the mesh was sound; it is then returned bit for bit
};

/// Repairs a mesh so that it encloses a solid, in this order: drops triangles that have the same vertex
/// twice, and repeated triangles; stitches borders (vertices within the tolerance, and vertices on border
/// edges); orients neighbours alike, by majority; fills every hole (up to 120 edges by the triangulation that
/// bends least, then is smallest; larger ones by ear clipping in their mean plane); turns bodies outwards;
/// drops bodies that enclose no volume. Sound features are not changed, such as edges where an even number of
/// triangles meet, bodies that touch or overlap, and triangles without area between three different vertices.
///
/// A sound mesh costs one pairing of its half-edges and one walk over its triangles.
///
/// @throws InvalidMesh if nothing that encloses a volume is left
RepairResult repairMesh(Mesh mesh, const RepairSettings& settings = {});

/// Checks that `repairMesh` would not change the mesh.
/// @throws InvalidMesh otherwise, naming the first defect and where it is
void requireSound(const Mesh& mesh);

}  // namespace lamina
