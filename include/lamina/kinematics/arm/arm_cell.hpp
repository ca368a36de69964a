// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Load on an arm's flange.
struct ToolLoad {
  double mass_kg = 0.0;
  Point3 centre_mm = Point3::Zero();  ///< centre of gravity, in link tool0
};

/// Frames of an arm's cell that a controller needs: the tool on the flange, and the bed.
struct ArmCell {
  /// From link tool0 to link nozzle [mm].
  Eigen::Isometry3d flange_from_nozzle = Eigen::Isometry3d::Identity();
  /// Pose of the bed relative to the root of the description or, if external axes carry the bed, relative to
  /// the link that the last of these axes moves [mm].
  Eigen::Isometry3d carrier_from_bed = Eigen::Isometry3d::Identity();
  bool is_bed_carried = false;  ///< by an external axis, such as a turntable
  /// What the flange carries, if the cell file states it (`mass_kg`, `centre_mm` of its tool).
  std::optional<ToolLoad> load;
};

/// The frames of an arm's cell, from its description.
ArmCell armCell(const KinematicModel& arm);

}  // namespace lamina
