// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "column_tops.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

ColumnTops::ColumnTops(const VoxelFrame& frame, double bed_z_mm)
    : frame_(frame),
      bed_z_mm_(bed_z_mm),
      above_bed_(static_cast<std::size_t>(frame.count[0]) * static_cast<std::size_t>(frame.count[1]), 0.0F) {}

void ColumnTops::raise(int i, int j, double z) {
  float& top = above_bed_[index(i, j)];
  top = std::max(top, static_cast<float>(z - bed_z_mm_));
}

double ColumnTops::at(double x, double y) const {
  const double i = std::floor((x - frame_.corner.x()) / frame_.voxel_mm);
  const double j = std::floor((y - frame_.corner.y()) / frame_.voxel_mm);
  const bool is_inside = i >= 0.0 && j >= 0.0 && i < frame_.count[0] && j < frame_.count[1];
  if (!is_inside) return bed_z_mm_;
  return bed_z_mm_ + static_cast<double>(above_bed_[index(static_cast<int>(i), static_cast<int>(j))]);
}

}  // namespace lamina
