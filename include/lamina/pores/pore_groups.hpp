// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// An end of the frame along an axis.
enum class AxisEnd : std::uint8_t { Low, High };

/// A face of the frame, as a bit: low x, high x, low y, and so on.
constexpr unsigned faceBit(int axis, AxisEnd end) {
  return 1U << static_cast<unsigned>(2 * axis + (end == AxisEnd::High ? 1 : 0));
}

/// Pore voxels that hang together by their faces.
struct PoreGroup {
  std::int64_t voxels = 0;
  unsigned faces = 0;  ///< of the frame that it touches, by `faceBit`
  /// Axes of the ellipsoid of equal second moments, longest first: 2 sqrt(5 lambda) with the variances lambda
  /// along them, a voxel counted as a cube (1/12) [voxels].
  std::array<double, 3> axes{};

  /// Whether it touches both faces of an axis.
  bool joinsAlong(int axis) const;
  /// Whether it touches both faces of some axis.
  bool joinsOpposite() const;
  /// Whether it touches two of the six faces.
  bool joinsTwoFaces() const;
  /// Of the sphere of equal volume [voxels].
  double equivalentDiameter() const;
};

/// Voxels of a row from `low` (included) to `high` (excluded) that belong to one group.
struct PoreRun {
  int low = 0;
  int high = 0;
  int j = 0;
  int k = 0;
  std::uint32_t group = 0;
};

/// The pores of a grid, parted into groups; these in the order of their first voxels, x fastest and z
/// slowest.
struct PoreGroups {
  VoxelFrame frame;
  std::vector<PoreRun> runs;  ///< by z, y, x
  std::vector<PoreGroup> groups;
};

/// Labels connected pores (neighbours share a face) by runs and union-find. Cost and memory are proportional
/// to words and runs. The result does not depend on the number of threads.
/// @param pores  solid where there is a pore
/// @throws InvalidInput if there are 2^32 runs or more
/// @throws Cancelled if `progress` is cancelled
PoreGroups labelPores(const VoxelGrid& pores, Progress& progress);

/// The voxels of the groups that `is_chosen` says.
VoxelGrid voxelsOf(const PoreGroups& pores, const std::function<bool(const PoreGroup&)>& is_chosen);

/// Open where the grid is solid and solid where it is open, in the same frame.
VoxelGrid inverted(const VoxelGrid& grid);

}  // namespace lamina
