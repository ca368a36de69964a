// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/deposition/path_follower.hpp"
#include "lamina/deposition/toolpath_deposit.hpp"

namespace lamina {

/// What a toolpath leaves behind, deposited as the nozzle comes by (`PathFollower`, `VoxelDeposit`). Once the
/// nozzle has been at the end, the volume is that of `depositedVoxels`, but its portions begin elsewhere.
class FollowedDeposit {
 public:
  static constexpr double kLeastPiece = 0.2;  ///< of a motion that is not at its end, deposited at once [mm]

  /// @param toolpath  in coordinates of the bed
  /// @throws InvalidInput as `depositedVoxels`, `PathFollower`
  FollowedDeposit(Toolpath toolpath, const DepositionSettings& settings, const FollowingSettings& following);
  FollowedDeposit(const FollowedDeposit&) = delete;
  FollowedDeposit& operator=(const FollowedDeposit&) = delete;

  /// Deposits what the nozzle has passed up to its reported position `tip` [mm, bed].
  void observe(const Point3& tip);

  const VoxelDeposit& deposit() const { return deposit_; }
  /// What the whole toolpath extrudes [mm³].
  double plannedVolume() const { return planned_mm3_; }
  bool isComplete() const { return follower_.isAtEnd(); }

 private:
  void layUpTo(const PathPlace& place);
  void layPart(const Path& path, double until);

  const Toolpath toolpath_;
  DepositionSettings settings_;
  PathFollower follower_;
  VoxelDeposit deposit_;
  PathPlace deposited_;  ///< up to there
  double planned_mm3_ = 0.0;
};

}  // namespace lamina
