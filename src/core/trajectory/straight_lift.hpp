// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/trajectory_settings.hpp"

namespace lamina {

/// The tool lifted straight against its tool axis, the tool axis held.
struct StraightLift {
  std::vector<JointValues> values;  ///< from where it starts, in equal steps
  double step_mm = 0.0;
  std::string stopped_by;  ///< why it does not reach its height; empty if it does
};

/// @param height_mm  0 or more; in steps of 1 mm at most
StraightLift straightLift(const JointValues& from, double height_mm, const KinematicModel& model,
                          const TrajectorySettings& settings);

}  // namespace lamina
