// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>

#include "lamina/geometry/voxel/height_map.hpp"

namespace octomap {
class OcTree;
}

namespace lamina {

/// The surface as an OctoMap: one occupied leaf, as large as a cell, at the height of each known cell;
/// nothing is marked free.
///
/// @param units_per_mm  the tree's unit of length: 1e-3 for metres, which OctoMap's own tools assume
/// @param tree_from_map  pose of the map in the tree's frame, translation [mm]
/// @throws InvalidInput if the map reaches farther than the tree's 32768 leaves from the origin
std::shared_ptr<octomap::OcTree> octreeOf(
    const HeightMap& surface, double units_per_mm,
    const Eigen::Isometry3d& tree_from_map = Eigen::Isometry3d::Identity());

/// Writes the tree as OctoMap's binary `.bt`; the file appears whole or not at all.
/// @throws FileError
void writeOctree(const std::string& path, const octomap::OcTree& tree);

}  // namespace lamina
