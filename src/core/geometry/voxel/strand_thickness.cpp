// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/strand_thickness.hpp"

#include <cstddef>
#include <cstdint>

namespace lamina {
namespace {

constexpr double kMostOfIt = 0.9;

/// Voxel (i, j, k) of the result from voxels i, i + 1, ... or i, i - 1, ... along an axis.
enum class CubeSide { Onwards, Backwards };

std::uint64_t rowWordAt(const VoxelGrid& grid, int w, int j, int k) {
  const auto& count = grid.frame().count;
  const bool is_inside = w >= 0 && w < grid.wordCount() && j >= 0 && j < count[1] && k >= 0 && k < count[2];
  return is_inside ? grid.word(w, j, k) : 0;
}

/// Bit b is voxel b + by of the row that the word belongs to; `by` within a word.
std::uint64_t shiftedWord(const VoxelGrid& grid, std::array<int, 3> at, int by) {
  const std::uint64_t own = rowWordAt(grid, at[0], at[1], at[2]);
  if (by == 0) return own;
  if (by > 0) return own >> by | rowWordAt(grid, at[0] + 1, at[1], at[2]) << (VoxelGrid::kWord - by);
  return own << -by | rowWordAt(grid, at[0] - 1, at[1], at[2]) >> (VoxelGrid::kWord + by);
}

std::uint64_t neighbours(const VoxelGrid& grid, std::array<int, 3> at, std::size_t axis, int by) {
  if (axis == 0) return shiftedWord(grid, at, by);
  at[axis] += by;
  return rowWordAt(grid, at[0], at[1], at[2]);
}

/// Onwards: solid where all `side` voxels from here on are. Backwards: where any of those up to here is.
VoxelGrid alongAxis(const VoxelGrid& grid, std::size_t axis, int side, CubeSide way) {
  VoxelGrid result(grid.frame());
  const auto& count = grid.frame().count;
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int w = 0; w < grid.wordCount(); ++w) {
        std::uint64_t bits = grid.word(w, j, k);
        for (int by = 1; by < side; ++by) {
          if (way == CubeSide::Onwards)
            bits &= neighbours(grid, {w, j, k}, axis, by);
          else
            bits |= neighbours(grid, {w, j, k}, axis, -by);
        }
        result.fillWord(w, j, k, bits);
      }
  return result;
}

}  // namespace

VoxelGrid inCubes(const VoxelGrid& grid, int side) {
  VoxelGrid corners = alongAxis(grid, 0, side, CubeSide::Onwards);
  for (const std::size_t axis : {std::size_t{1}, std::size_t{2}})
    corners = alongAxis(corners, axis, side, CubeSide::Onwards);
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}, std::size_t{2}})
    corners = alongAxis(corners, axis, side, CubeSide::Backwards);
  return corners;
}

StrandThickness strandThicknessOf(const VoxelGrid& grid) {
  StrandThickness thickness;
  const auto solid = static_cast<double>(grid.solidCount());
  if (solid == 0.0) return thickness;
  for (thickness.voxels = kStrandVoxels; thickness.voxels > 1; --thickness.voxels) {
    const double held = static_cast<double>(inCubes(grid, thickness.voxels).solidCount()) / solid;
    if (thickness.voxels == kStrandVoxels) thickness.thin_share = 1.0 - held;
    if (held >= kMostOfIt) return thickness;
  }
  return thickness;
}

}  // namespace lamina
