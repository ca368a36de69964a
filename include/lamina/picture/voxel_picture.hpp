// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/geometry/voxel/voxel_grid.hpp"
#include "lamina/picture/height_map_picture.hpp"

namespace lamina {

/// A sheet of voxels of a grid that is normal to an axis (0 for x, 1 for y, 2 for z).
struct VoxelSheet {
  std::size_t axis = 2;
  int index = 0;  ///< of the sheet along that axis
};

/// The sheet normal to an axis that contains a coordinate [mm].
/// @throws InvalidInput if the coordinate is beyond the frame
VoxelSheet sheetAt(const VoxelFrame& frame, std::size_t axis, double at_mm);

/// Draws a sheet as a PNG, solid dark and open light, with a scale bar. It is seen from above if normal to z,
/// from the front if normal to y, from the side if normal to x, with z up. The picture shows the bounding box
/// of all solid voxels of the grid. Where voxels are finer than pixels, a pixel is as dark as its solid
/// share.
/// @throws InvalidInput if nothing in the grid is solid
/// @throws FileError
void drawVoxelSheet(const std::string& path, const VoxelGrid& grid, const VoxelSheet& sheet,
                    const PictureTitle& title);

}  // namespace lamina
