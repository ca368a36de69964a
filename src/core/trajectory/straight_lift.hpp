// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/trajectory_settings.hpp"

namespace lamina {

/// Joint values by which the tool is lifted straight against its tool axis, with constant orientation.
struct StraightLift {
  std::vector<JointValues> values;  ///< in equal steps, the first at the start
  double step_mm = 0.0;
  std::string stopped_by;  ///< why the height is not reached; empty if it is
};

/// Plans a lift.
/// @param height_mm  0 or more; steps are at most 1 mm
StraightLift straightLift(const JointValues& from, double height_mm, const KinematicModel& model,
                          const TrajectorySettings& settings);

}  // namespace lamina
