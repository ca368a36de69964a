// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// A collision body of a description, in words.
struct ReportedBody {
  std::string link;
  std::string shape;  ///< "box", "cylinder", "cone", "sphere", "mesh"
  std::size_t triangles = 0;
};

/// What a description says of a robot.
struct RobotReport {
  std::string name;
  std::vector<DrivenJoint> joints;  ///< in the order of the chain
  std::string kinematic_class;      ///< by which its inverse kinematics are solved
  std::string flange;               ///< link at its end
  Eigen::Isometry3d base_from_flange_at_zero = Eigen::Isometry3d::Identity();  ///< over the root [mm]
  double reach_mm = 0.0;  ///< farthest of the flange from axis 1, among 2000 poses that are always the same
  std::vector<ReportedBody> bodies;
  std::vector<std::string> traps;  ///< what a person must know before relying on it
};

/// A description with the links that a kinematic model asks for: if it has none, a bed at its root and a
/// nozzle at its flange, which is tool0, flange, or else the end of its longest chain.
/// @throws InvalidConfig if it is no URDF
std::string withBedAndNozzle(const std::string& urdf);

/// @param urdf  as `readMachineDescription` gives it
/// @throws InvalidConfig if it is no robot with six rotary joints that Lamina can lead
RobotReport robotReport(const std::string& urdf);

}  // namespace lamina
