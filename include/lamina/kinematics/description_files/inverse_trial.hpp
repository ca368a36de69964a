// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Result of a test of an arm's inverse kinematics on poses within its reach.
struct InverseTrial {
  std::size_t poses = 0;
  std::size_t reached = 0;    ///< poses with solutions, all of which lead back to the pose
  std::size_t recovered = 0;  ///< of the reached poses, those whose solutions include the drawn joints
  std::size_t regular = 0;    ///< poses whose drawn joints are at least 1.15 deg from any singularity
  std::size_t regular_recovered =
      0;                        ///< of the regular poses, those whose solutions include the drawn joints
  double tip_error_mm = 0.0;    ///< greatest distance of a solution's nozzle from its pose
  double turn_error_rad = 0.0;  ///< greatest angle between a solution's nozzle and its pose
  /// Whether a pose far out of reach has no solution, as it should.
  bool ends = false;

  bool isPassed() const { return reached == poses && ends; }
};

/// Draws joint values within their limits, the same in every run, and solves for the pose of the nozzle at
/// each. A solution leads back to the pose if its own pose agrees within 1e-4 mm and 1e-7 rad.
InverseTrial tryInverse(const KinematicModel& arm, std::size_t poses);

}  // namespace lamina
