// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/mesh_io/mesh_objects.hpp"

namespace lamina {

/// A part fit to be sliced, and what was changed to make it so.
struct SourcePart {
  Mesh mesh;
  MeshTopology topology;  ///< of the mesh; without border
  std::vector<std::string> repairs;
  Eigen::Affine3d part_from_file = Eigen::Affine3d::Identity();  ///< where a plate has turned it
  std::vector<MeshVolume> volumes = {};                          ///< of its file, in the file's coordinates
  Mesh base;  ///< what it is deposited on, in its frame; empty for the bed
};

}  // namespace lamina
