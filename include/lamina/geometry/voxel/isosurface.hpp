// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Returns how far inside a lattice point lies: positive inside, negative outside. It is called for pairs of
/// neighbours on different sides of the surface, also for points one step outside the frame.
using DepthInside = std::function<double(int i, int j, int k)>;

/// The closed surface between lattice points that are inside and those that are not, by marching cubes
/// [Lorensen1987]. Lattice points are the centres of the voxels; the centres of solid voxels of `inside` are
/// inside, and all points beyond its frame are outside. If on a face of a cube two diagonally opposite
/// corners are inside and the other two are not, the two inside are kept apart, in both cubes that share the
/// face. The surface is therefore closed, has no edge with more than two triangles, and faces outwards.
///
/// Time is proportional to the words of the grid and to the surface; memory to a slice and to the surface.
///
/// @param depth  places vertices between two points by linear interpolation; empty: vertices lie midway
/// @throws InvalidMesh if there are more vertices than a mesh can number
Mesh isosurface(const VoxelGrid& inside, const DepthInside& depth = {});

}  // namespace lamina
