// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// What a controller needs to know of an arm's cell: where the tool is on the flange, and where the bed is.
struct ArmCell {
  Eigen::Isometry3d flange_from_nozzle = Eigen::Isometry3d::Identity();  ///< link tool0 to link nozzle [mm]
  /// The bed over the root of the description; where an external axis carries it, over the link that the last
  /// of these axes moves [mm].
  Eigen::Isometry3d carrier_from_bed = Eigen::Isometry3d::Identity();
  bool is_bed_carried = false;  ///< by an external axis, as a turntable
};

/// The cell of a description.
/// @throws InvalidConfig if the kinematic model is no six-axis arm, or has no link tool0
ArmCell armCell(const KinematicModel& arm);

}  // namespace lamina
