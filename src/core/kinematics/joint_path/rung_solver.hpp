// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kinematics/joint_path/rung.hpp"
#include "kinematics/joint_path/stations.hpp"
#include "kinematics/model/joint_ranges.hpp"
#include "lamina/kinematics/joint_path/joint_guard.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Finds all joint values by which a kinematic model reaches a station. Objects are immutable, and calls may
/// come from several threads. The kinematic model and the guard must outlive it.
class RungSolver {
 public:
  RungSolver(const GuardedModel& guarded, const JointPathSettings& settings);
  /// @param ranges  ranges of the model's joints; a joint that could wind may be given as one that does not
  RungSolver(const GuardedModel& guarded, const JointPathSettings& settings, std::vector<JointRange> ranges);

  /// The rung of a station. Its nodes are within the limits, allowed by the guard, and no nearer to a
  /// singularity than the settings allow; rotary values are the equivalent ones nearest to the middle of the
  /// limits. Without nodes if the station cannot be reached so.
  Rung solve(const Station& station) const;

  /// Joint values for a coordinate [rad] that need not be one of the samples.
  /// @return nothing if the node does not exist
  std::optional<JointValues> at(const Station& station, SampleKind kind, double coordinate, int branch) const;

  /// Reason why the rung of a station has no node.
  struct Hindrance {
    JointFault fault = JointFault::OutOfReach;
    std::string reason;
  };
  Hindrance hindrance(const Station& station) const;

  /// Whether joint values are within the limits and allowed by the guard.
  bool isAllowed(const JointValues& values) const;

  double coordinateOf(SampleKind kind, NodeId node) const;
  const std::vector<JointRange>& ranges() const { return ranges_; }

 private:
  struct Asked {
    SampleKind kind = SampleKind::Single;
    Eigen::Isometry3d bed_from_nozzle;
    JointValues near;
    double redundancy = 0.0;  ///< as in `Station`
    std::vector<InverseSolution> found =
        {};  ///< those of a single sample; empty if nobody has looked for them
  };

  Asked askedAt(const Station& station) const;
  Eigen::Isometry3d passing(const Eigen::Isometry3d& bed_from_nozzle, const JointValues& values) const;
  JointValues nearFor(const std::array<double, 3>& external) const;
  InverseSolutions inverse(const Asked& asked, const Eigen::Isometry3d& bed_from_nozzle,
                           const JointValues& near) const;
  JointValues withFree(JointValues near, double free_value) const;
  InverseSolutions solutionsAt(const Asked& asked, double coordinate) const;
  void addNode(const InverseSolution& solution, std::size_t slot, Rung& rung) const;
  bool isWithinLimits(const JointValues& values) const;
  double penaltyOf(const JointValues& values) const;
  std::string headHindrance(const Station& station) const;
  double greatestExcess(const JointValues& values) const;
  Hindrance limitHindrance(const JointValues& values) const;

  const KinematicModel* model_;
  const JointGuard* guard_;
  JointPathSettings settings_;
  std::vector<JointRange> ranges_;
  std::vector<bool> is_external_;
  double least_margin_;    ///< as `KinematicModel::singularityMargin`
  double avoided_margin_;  ///< as `KinematicModel::singularityMargin`
};

}  // namespace lamina
