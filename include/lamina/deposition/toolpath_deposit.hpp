// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/deposition/deposition_settings.hpp"
#include "lamina/deposition/voxel_deposit.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The deposit of a toolpath.
struct ToolpathDeposit {
  VoxelGrid grid;
  DepositTotals totals;
  double highest_mm = 0.0;  ///< top of the deposit, as `VoxelDeposit::highest`
};

/// A motion of a path of beads; its volume is 0 if it deposits nothing. The strand is round and has the
/// cross-section of the bead.
ToolAxisMotion toolAxisMotion(const Path& path, std::size_t motion);

/// The drop at a waypoint: a ball with the volume of the drop's disc.
ToolAxisMotion toolAxisDrop(const Path& path, std::size_t waypoint);

/// The motions of a path that extrude, in order: one per motion of a bead, or one per drop. The volume is the
/// bead's cross-section times the length, or that of the drop's disc.
std::vector<ToolAxisMotion> toolAxisMotions(const Path& path);

/// The box of the deposit: the bounding box of the depositing motions, enlarged on all sides by five radii of
/// the thickest strand (or by the reach, if that is less) and a voxel, but not below the bed. Empty if
/// nothing is deposited.
Box3 depositBox(const Toolpath& toolpath, const DepositionSettings& settings);

/// Memory that `depositedVoxels` needs for the voxels [bytes], estimated by following the toolpath.
double depositBytes(const Toolpath& toolpath, const DepositionSettings& settings);

/// An empty deposit with room for a toolpath, to deposit it bit by bit.
/// @throws InvalidInput as `depositedVoxels`
VoxelDeposit roomFor(const Toolpath& toolpath, const DepositionSettings& settings);

/// Whether a path is deposited: travels are not; build aids (skirt, brim, raft, supports, priming) are only
/// if `are_build_aids_deposited` is set.
bool isDeposited(const Path& path, const DepositionSettings& settings);

/// Deposits a toolpath, in coordinates of the bed, from its first motion to its last (`VoxelDeposit`). The
/// result is the same for any number of threads.
/// @throws InvalidInput if nothing is deposited; stating a voxel size that would fit, if the voxels would
///   take more memory than deposition.memory_limit_mb (or than is available)
/// @throws Cancelled if `progress` is cancelled
ToolpathDeposit depositedVoxels(const Toolpath& toolpath, const DepositionSettings& settings,
                                Progress& progress);

}  // namespace lamina
