// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The cross-section of a mesh in one plane.
struct Section {
  /// Closed contours with material on their left: outer ones counter-clockwise, holes clockwise.
  std::vector<Polygon> contours;
  std::vector<Polyline> open_contours;  ///< contours that end at a border of the mesh; none on a closed mesh
};
/// Cross-sections of a mesh in the planes z = heights[i]. A section is that of the material just above its
/// plane (z + 0): a plane through the bottom face gives that face, a plane through the top face gives
/// nothing, and a vertex or edge that only touches the plane from below has no effect. Contours are chained
/// by the topology of the mesh, never by distance: on a closed mesh (every edge has as many triangles in one
/// orientation as in the other) all contours are closed, and at edges where more than two triangles meet,
/// contours touch without crossing. Contours are not united: where bodies overlap, their contours do, too.
///
/// @param mesh     vertices [mm, part frame]
/// @param heights  z of the planes [mm], ascending
/// @return one section per height, empty if the plane misses the mesh; the same for any number of threads
/// @throws Cancelled if `progress` is cancelled
std::vector<Section> sliceMesh(const Mesh& mesh, const std::vector<double>& heights, Progress& progress);

/// Cross-sections of a mesh whose topology is already known, as after `repairMesh`; as the function above.
std::vector<Section> sliceMesh(const Mesh& mesh, const MeshTopology& topology,
                               const std::vector<double>& heights, Progress& progress);

}  // namespace lamina
