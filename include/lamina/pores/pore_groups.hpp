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

/// A connected group of pore voxels; neighbours share a face.
struct PoreGroup {
  std::int64_t voxels = 0;
  unsigned faces = 0;  ///< faces of the frame that the group touches, as bits of `faceBit`
  /// Lengths of the axes of the ellipsoid of equal second moments [voxels], longest first: 2 sqrt(5 lambda),
  /// where lambda are the principal variances of the group. A voxel counts as a cube, which adds 1/12 to each
  /// variance.
  std::array<double, 3> axes{};

  /// Whether the group touches both faces of the frame along an axis.
  bool joinsAlong(int axis) const;
  /// Whether the group touches both faces of the frame along at least one axis.
  bool joinsOpposite() const;
  /// Whether the group touches two or more of the six faces of the frame.
  bool joinsTwoFaces() const;
  /// Diameter of the sphere of equal volume [voxels].
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

/// The pores of a grid, divided into groups. The groups are in the order of their first voxels, x fastest and
/// z slowest.
struct PoreGroups {
  VoxelFrame frame;
  std::vector<PoreRun> runs;  ///< sorted by z, y, x
  std::vector<PoreGroup> groups;
};

/// Labels connected pores (neighbours share a face) by runs and union-find. Cost and memory are proportional
/// to the words of the grid and the runs. The result does not depend on the number of threads.
/// @param pores  solid where there is a pore
/// @throws InvalidInput if there are 2^32 runs or more
/// @throws Cancelled if `progress` is cancelled
PoreGroups labelPores(const VoxelGrid& pores, Progress& progress);

/// The voxels of the groups for which `is_chosen` is true.
VoxelGrid voxelsOf(const PoreGroups& pores, const std::function<bool(const PoreGroup&)>& is_chosen);

/// The grid that is open where `grid` is solid, and solid where it is open, in the same frame.
VoxelGrid inverted(const VoxelGrid& grid);

}  // namespace lamina
