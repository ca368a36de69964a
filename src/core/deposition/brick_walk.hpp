// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/deposition/voxel_deposit.hpp"

namespace lamina {

/// Counts the bricks of a voxel grid that motions come near to, before there is a grid.
class BrickWalk {
 public:
  explicit BrickWalk(const VoxelFrame& frame);

  void follow(const ToolAxisMotion& motion);
  /// Memory of a grid with those bricks [bytes]; of one with all bricks where there are too many to mark.
  double bytes() const;

 private:
  void mark(const Point3& middle, double around_mm);

  VoxelFrame frame_;
  std::array<std::int64_t, 3> bricks_{};
  std::vector<bool> is_met_;  ///< by brick; empty if there are too many
  std::int64_t met_ = 0;
};

}  // namespace lamina
