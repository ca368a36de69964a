// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/geometry/voxel/voxel_grid.hpp"
#include "lamina/picture/height_map_picture.hpp"

namespace lamina {

/// Which sheet of voxels of a grid is looked at: square to an axis (0 for x, 1 for y, 2 for z).
struct VoxelSheet {
  std::size_t axis = 2;
  int index = 0;  ///< of the voxels along that axis
};

/// The sheet square to an axis that holds a coordinate [mm].
/// @throws InvalidInput if it is beyond the frame
VoxelSheet sheetAt(const VoxelFrame& frame, std::size_t axis, double at_mm);

/// Draws a sheet as a PNG, solid dark and open light, with a scale bar. Seen from above, or from the front
/// (square to y) or the side (square to x), z up. Shown is the box of all that is solid, whatever the sheet;
/// where voxels are finer than pixels, a pixel is as dark as its share that is solid.
/// @throws InvalidInput if nothing in the grid is solid
/// @throws FileError
void drawVoxelSheet(const std::string& path, const VoxelGrid& grid, const VoxelSheet& sheet,
                    const PictureTitle& title);

}  // namespace lamina
