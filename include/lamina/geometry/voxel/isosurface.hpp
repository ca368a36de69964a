// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// How far inside a lattice point lies: positive inside, negative outside. Asked for neighbours one of which
/// is inside and the other not; asked for points one step beyond the frame too.
using DepthInside = std::function<double(int i, int j, int k)>;

/// The closed surface between the lattice points that are inside and those that are not, by marching cubes
/// [Lorensen1987]. Lattice points are the centres of the voxels; `inside` is solid where they are
/// inside, and everything beyond its frame is outside. Where the corners of a face of a cube are inside
/// crosswise, the two are kept apart, on both sides of the face alike. So the surface is closed, free of
/// edges with more than two triangles, and faces outwards.
///
/// Cost is proportional to the words of the grid and to the surface; memory to a slice and to the surface.
///
/// @param depth  places vertices between the two points by linear interpolation; empty for half way
/// @throws InvalidMesh if there are more vertices than a mesh can number
Mesh isosurface(const VoxelGrid& inside, const DepthInside& depth = {});

}  // namespace lamina
