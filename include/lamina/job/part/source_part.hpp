// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/mesh_io/mesh_objects.hpp"

namespace lamina {

/// A part that can be sliced, and what was repaired to make it so.
struct SourcePart {
  Mesh mesh;
  MeshTopology topology;  ///< of `mesh`; without border
  std::vector<std::string> repairs;
  /// Transform by which a plate has rotated, scaled and moved the part.
  Eigen::Affine3d part_from_file = Eigen::Affine3d::Identity();
  /// Volumes of the part's file with settings of their own, in the file's coordinates.
  std::vector<MeshVolume> volumes = {};
  /// For a part of a plate, the bed at the part's place [mm, frame of the part]: brims end at its edge, too.
  std::optional<Box2> bed_around = std::nullopt;
  Mesh base;  ///< surface on which the part is deposited [frame of the part]; empty for the bed
};

}  // namespace lamina
