// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// One kind of change: so many of these, the first of them (or the middle of the hole) here.
struct RepairChange {
  std::string what;  ///< "degenerate triangles dropped"
  std::size_t count = 0;
  Point3 where = Point3::Zero();  ///< [mm, part frame]
};

/// "8 degenerate triangles dropped near (1.5, 2, 0.3) mm"
std::string toText(const RepairChange& change);

/// How far a repair may change a mesh.
struct RepairSettings {
  /// Border vertices nearer than this become one [mm]; at most 1e-4 of the mesh's diagonal is used.
  double stitch_tolerance_mm = 0.01;
};

/// A mesh that encloses a solid: every edge has as many half-edges one way as the other, no triangle names a
/// vertex twice, every body faces outwards (a body inside another may face inwards: a cavity).
struct RepairResult {
  Mesh mesh;
  MeshTopology topology;              ///< of the mesh; without border
  std::vector<RepairChange> changes;  ///< empty if the mesh was sound: then it is unchanged bit for bit
};

/// Makes a mesh enclose a solid, step by step: drops triangles that name a vertex twice and repeated
/// triangles; stitches borders (vertices within the tolerance, and vertices on border edges); orients
/// neighbours alike, by majority; fills every hole (up to 120 edges by the triangulation that bends least,
/// then smallest, larger ones by ear clipping in their mean plane); turns bodies outwards; drops bodies that
/// enclose no volume. What is sound is left alone: edges where an even number of triangles meet, bodies that
/// touch or overlap, triangles without area between three different vertices.
///
/// A sound mesh costs one pairing of its half-edges and one walk over its triangles.
///
/// @throws InvalidMesh if nothing that encloses a volume is left
RepairResult repairMesh(Mesh mesh, const RepairSettings& settings = {});

/// @throws InvalidMesh naming the first defect and where it is, if `repairMesh` would change the mesh
void requireSound(const Mesh& mesh);

}  // namespace lamina
