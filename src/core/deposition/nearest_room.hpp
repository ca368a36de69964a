// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Lengths within a search count in 256ths of a voxel, as whole numbers: so distances compare exactly.
inline constexpr int kFine = 256;

/// Where a portion of material comes out. Lengths are in voxels, from the corner of the frame.
struct Outlet {
  Point3 tip = Point3::Zero();  ///< the plane through it, square to the tool axis, is not passed
  Eigen::Vector3d tool_axis{0, 0, -1};
  Point3 middle = Point3::Zero();  ///< what lies nearest is filled first
};

/// A voxel that may be filled.
struct OpenVoxel {
  std::int64_t distance2 = 0;  ///< from the middle, squared [256ths of a voxel]
  int i = 0;
  int j = 0;
  int k = 0;
};

/// Finds the open voxels nearest to an outlet. It remembers the ball that the last search left full, and
/// looks only around it as long as the outlets follow each other: voxels only ever become solid.
class NearestRoom {
 public:
  /// @param lowest_k     voxels below are never room
  /// @param reach        farthest from the middle [voxels]
  NearestRoom(int lowest_k, double reach);

  /// The `count` open voxels of the grid nearest to the outlet's middle, or all within reach if there are
  /// fewer. All of them must be solid before the next call. Of those at the same distance, one side of the
  /// middle comes first, another at every call.
  const std::vector<OpenVoxel>& find(const VoxelGrid& grid, const Outlet& outlet, std::int64_t count);

 private:
  struct Search;
  struct Row;

  std::int64_t radiusKnownFull(const Search& search) const;
  void collect(const Search& search, std::int64_t inner, std::int64_t outer);
  void collectRow(const Search& search, const Row& row, std::int64_t inner, std::int64_t outer);
  std::int64_t keepNearest(std::int64_t count);

  int lowest_k_;
  std::int64_t reach_;       ///< [256ths of a voxel], as all below
  std::int64_t usual_ = 0;   ///< how far the last search went
  std::uint32_t calls_ = 0;  ///< decides between sides
  std::vector<OpenVoxel> found_;
  Outlet last_;
  std::array<std::int64_t, 3> last_middle_{};
  std::int64_t full_ = 0;  ///< every voxel nearer than this to the last middle, behind its plane, is solid
};

}  // namespace lamina
