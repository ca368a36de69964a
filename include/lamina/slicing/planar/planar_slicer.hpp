// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// What one plane cuts out of a mesh.
struct Section {
  std::vector<Polygon>
      contours;  ///< closed; material on the left: outer ones counter-clockwise, holes clockwise
  std::vector<Polyline> open_contours;  ///< where the mesh has a border; none on a closed mesh
};

/// Sections of a mesh with the planes z = heights[i], the mesh's material taken just above each plane (z +
/// 0): a plane through the bottom face gives that face, a plane through the top face gives nothing, and a
/// vertex or edge that only touches the plane from below leaves no trace. Contours are chained by the mesh's
/// topology, never by distance: on a closed mesh (every edge with as many triangles one way as the other) all
/// contours are closed, and along edges where more than two triangles meet, contours touch without crossing.
/// Contours are not united: where bodies overlap, so do theirs.
///
/// @param mesh     vertices [mm, part frame]
/// @param heights  z of the planes [mm], ascending
/// @return one section per height; empty where the plane misses the mesh. The same for any number of threads.
/// @throws Cancelled if `progress` is cancelled
std::vector<Section> sliceMesh(const Mesh& mesh, const std::vector<double>& heights, Progress& progress);

/// The same where the mesh's topology is known already, as after `repairMesh`.
std::vector<Section> sliceMesh(const Mesh& mesh, const MeshTopology& topology,
                               const std::vector<double>& heights, Progress& progress);

}  // namespace lamina
