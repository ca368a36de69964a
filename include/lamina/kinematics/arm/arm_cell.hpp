// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Frames of an arm's cell that a controller needs: that of the tool on the flange, and that of the bed.
struct ArmCell {
  /// From link tool0 to link nozzle [mm].
  Eigen::Isometry3d flange_from_nozzle = Eigen::Isometry3d::Identity();
  /// Pose of the bed relative to the root of the description or, if external axes carry the bed, relative to
  /// the link that the last of these axes moves [mm].
  Eigen::Isometry3d carrier_from_bed = Eigen::Isometry3d::Identity();
  bool is_bed_carried = false;  ///< by an external axis, such as a turntable
};

/// The frames of an arm's cell, from its description.
ArmCell armCell(const KinematicModel& arm);

}  // namespace lamina
