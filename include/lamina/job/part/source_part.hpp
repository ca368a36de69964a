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
  /// How a plate has rotated, scaled and moved it.
  Eigen::Affine3d part_from_file = Eigen::Affine3d::Identity();
  /// Volumes of its file with settings of their own, in the file's coordinates.
  std::vector<MeshVolume> volumes = {};
  /// Of a part of a plate, the bed from where it will stand [mm, frame of the part]: brims end there, too.
  std::optional<Box2> bed_around = std::nullopt;
  Mesh base;  ///< surface on which the part is deposited [frame of the part]; empty for the bed
};

}  // namespace lamina
