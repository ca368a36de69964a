// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/deposition/path_follower.hpp"
#include "lamina/deposition/toolpath_deposit.hpp"

namespace lamina {

/// The deposit of a toolpath, built up as the nozzle is reported along it (`PathFollower`, `VoxelDeposit`).
/// Once the nozzle has been at the end, the volume is that of `depositedVoxels`, but portions begin at other
/// points.
class FollowedDeposit {
 public:
  /// Least length that is deposited of a motion that is not at its end [mm].
  static constexpr double kLeastPiece = 0.2;

  /// @param toolpath  in coordinates of the bed
  /// @throws InvalidInput as `depositedVoxels` and `PathFollower`
  FollowedDeposit(Toolpath toolpath, const DepositionSettings& settings, const FollowingSettings& following);
  FollowedDeposit(const FollowedDeposit&) = delete;
  FollowedDeposit& operator=(const FollowedDeposit&) = delete;

  /// Deposits what the nozzle has passed up to its reported position `tip` [mm, bed].
  void observe(const Point3& tip);

  const VoxelDeposit& deposit() const { return deposit_; }
  /// Volume that the whole toolpath extrudes [mm³].
  double plannedVolume() const { return planned_mm3_; }
  bool isComplete() const { return follower_.isAtEnd(); }

 private:
  void layUpTo(const PathPosition& place);
  void layPart(const Path& path, double until);

  const Toolpath toolpath_;
  DepositionSettings settings_;
  PathFollower follower_;
  VoxelDeposit deposit_;
  PathPosition deposited_;  ///< position up to which the toolpath is deposited
  double planned_mm3_ = 0.0;
};

}  // namespace lamina
