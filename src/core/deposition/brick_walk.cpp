// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "brick_walk.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr std::array<int, 3> kVoxels{VoxelGrid::kWord, VoxelGrid::kBrick, VoxelGrid::kBrick};
constexpr double kMostBricks = 4e9;
constexpr double kTableEntry = 4.0;  // bytes
constexpr double kBrickBytes =
    8.0 * VoxelGrid::kBrick * VoxelGrid::kBrick + 32.0;  // and of its place in store
constexpr double kStride = 4.0;                          // voxels along a motion
constexpr double kAround = 1.3;                          // radii of the strand
constexpr double kStrideOfStrand = 0.5;                  // radii of the strand

}  // namespace

BrickWalk::BrickWalk(const VoxelFrame& frame) : frame_(frame) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    bricks_[axis] = (std::int64_t{frame.count[axis]} + kVoxels[axis] - 1) / kVoxels[axis];
  const double bricks = double(bricks_[0]) * double(bricks_[1]) * double(bricks_[2]);
  if (bricks <= kMostBricks) is_met_.resize(static_cast<std::size_t>(bricks));
}

void BrickWalk::follow(const ToolAxisMotion& motion) {
  if (is_met_.empty()) return;
  const double length = (motion.end - motion.start).norm();
  const double stride_mm = std::max(kStride * frame_.voxel_mm, kStrideOfStrand * motion.radius_mm);
  const double strides = std::ceil(length / stride_mm);
  const double around = kAround * motion.radius_mm + frame_.voxel_mm;
  for (double stride = 0.0; stride <= strides; ++stride) {
    const double fraction = strides > 0.0 ? stride / strides : 0.0;
    const Eigen::Vector3d tool_axis =
        (1.0 - fraction) * motion.start_tool_axis + fraction * motion.end_tool_axis;
    mark(motion.start + fraction * (motion.end - motion.start) + motion.radius_mm * tool_axis, around);
  }
}

double BrickWalk::bytes() const {
  const double bricks = double(bricks_[0]) * double(bricks_[1]) * double(bricks_[2]);
  const double met = is_met_.empty() ? bricks : static_cast<double>(met_);
  return kTableEntry * bricks + kBrickBytes * met;
}

void BrickWalk::mark(const Point3& middle, double around_mm) {
  std::array<std::int64_t, 3> low{};
  std::array<std::int64_t, 3> high{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double brick_mm = kVoxels[axis] * frame_.voxel_mm;
    const double at = middle[a] - frame_.corner[a];
    const auto last = static_cast<double>(bricks_[axis] - 1);
    low[axis] = static_cast<std::int64_t>(std::clamp(std::floor((at - around_mm) / brick_mm), 0.0, last));
    high[axis] = static_cast<std::int64_t>(std::clamp(std::floor((at + around_mm) / brick_mm), 0.0, last));
  }
  for (std::int64_t k = low[2]; k <= high[2]; ++k)
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
      for (std::int64_t i = low[0]; i <= high[0]; ++i) {
        auto is_met = is_met_[static_cast<std::size_t>((k * bricks_[1] + j) * bricks_[0] + i)];
        if (is_met) continue;
        is_met = true;
        ++met_;
      }
}

}  // namespace lamina
