// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Area of all voxel faces between solid and open [mm²], including those on the border of the frame
/// [Vega2023, section 7.2.2.6].
double voxelFaceArea(const VoxelGrid& solid);

}  // namespace lamina
