// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Height of the top in each column of voxels, as floats [mm above the bed].
class ColumnTops {
 public:
  ColumnTops(const VoxelFrame& frame, double bed_z_mm);

  void raise(int i, int j, double z);
  double at(double x, double y) const;

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(frame_.count[0]) +
           static_cast<std::size_t>(i);
  }

  VoxelFrame frame_;
  double bed_z_mm_;
  std::vector<float> above_bed_;
};

}  // namespace lamina
