// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// A collision body of a description, in words.
struct ReportedBody {
  std::string link;
  std::string shape;  ///< "box", "cylinder", "cone", "sphere", "mesh"
  std::size_t triangles = 0;
};

/// Summary of a robot's description.
struct RobotReport {
  std::string name;
  std::vector<DrivenJoint> joints;  ///< in order from base to flange
  std::string kinematic_class;      ///< class of kinematics, by which the inverse kinematics are solved
  std::string redundancy;           ///< what a pose of the flange leaves free, in words; empty if nothing
  std::string flange;               ///< link at the end of the chain
  /// Pose of the flange relative to the root, with all joints at zero [mm].
  Eigen::Isometry3d base_from_flange_at_zero = Eigen::Isometry3d::Identity();
  /// Greatest distance of the flange from axis 1 among 2000 poses, which are the same in every run.
  double reach_mm = 0.0;
  std::vector<ReportedBody> bodies;  ///< for collision
  /// Links that are never checked against each other: neighbours, and those that the cell ignores.
  std::vector<std::pair<std::string, std::string>> unchecked;
  std::vector<std::string> traps;  ///< warnings for people who want to use the description
};

/// The description with the links `bed` and `nozzle` that a kinematic model requires. If it lacks them, the
/// bed is put at its root and the nozzle at its flange: the link tool0, else flange, else the end of the
/// longest chain.
/// @throws InvalidConfig if it is no URDF
std::string withBedAndNozzle(const std::string& urdf);

/// The summary of a robot's description.
/// @param urdf  as `readMachineDescription` returns it
/// @throws InvalidConfig if it is no robot with five to seven rotary joints whose inverse kinematics Lamina
/// can solve
RobotReport robotReport(const std::string& urdf);

}  // namespace lamina
