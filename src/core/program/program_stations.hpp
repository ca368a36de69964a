// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_text.hpp"

namespace lamina {

/// Stations of a joint path, found by path of its toolpath: the station at which a path begins, and the one
/// at the end of each of its motions.
class ProgramStations {
 public:
  /// Checks that the kinematic model can run the joint path.
  /// @throws Unreachable  if the joint path has faults, or a joint is outside its limits
  /// @throws InvalidInput if the joint path does not belong to this toolpath at this position
  ProgramStations(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                  const KinematicModel& model, const JointPath& joints);

  /// @param path  index, counted through all layers
  const JointValues& begin(std::size_t path) const { return joints_.values[first_[path]]; }
  const JointValues& end(std::size_t path, std::size_t motion) const {
    return joints_.values[first_[path] + 1 + motion];
  }

 private:
  const JointPath& joints_;
  std::vector<std::size_t> first_;  ///< station at which each path begins
};

}  // namespace lamina
