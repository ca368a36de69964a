// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/deposition/deposition_settings.hpp"
#include "lamina/deposition/voxel_deposit.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What a toolpath leaves behind.
struct ToolpathDeposit {
  VoxelGrid grid;
  DepositTotals totals;
  double highest_mm = 0.0;  ///< `VoxelDeposit::highest`
};

/// Motion m of a path of beads; without volume if it deposits nothing. The strand is round and of the same
/// cross-section as the bead.
ToolAxisMotion toolAxisMotion(const Path& path, std::size_t motion);

/// The drop at a waypoint: a ball of the same volume as its disc.
ToolAxisMotion toolAxisDrop(const Path& path, std::size_t waypoint);

/// The motions of a path that extrude, in order: one per motion of a bead, one per drop. Volume is the
/// bead's cross-section times the length, or the disc of the drop.
std::vector<ToolAxisMotion> toolAxisMotions(const Path& path);

/// Box for what is deposited: around the waypoints that deposit, wider on all sides by five radii of the
/// thickest strand (or the reach, if that is less) and a voxel, not below the bed. Empty if nothing is
/// deposited.
Box3 depositBox(const Toolpath& toolpath, const DepositionSettings& settings);

/// Memory that `depositedVoxels` needs for the voxels, from a walk along the path [bytes].
double depositBytes(const Toolpath& toolpath, const DepositionSettings& settings);

/// A deposit with room for a toolpath, nothing deposited yet: what lays it bit by bit begins with this.
/// @throws InvalidInput as `depositedVoxels`
VoxelDeposit roomFor(const Toolpath& toolpath, const DepositionSettings& settings);

/// Whether the path is deposited: no travel, and a skirt only if the settings say so.
bool isDeposited(const Path& path, const DepositionSettings& settings);

/// Lays a toolpath, in coordinates of the bed, from its first motion to its last (`VoxelDeposit`).
/// The result is the same whatever the number of threads.
/// @throws InvalidInput if nothing is deposited, or the voxels would take more memory than
///   deposition.memory_limit_mb (or than is free): it names a voxel size that would fit
/// @throws Cancelled
ToolpathDeposit depositedVoxels(const Toolpath& toolpath, const DepositionSettings& settings,
                                Progress& progress);

}  // namespace lamina
