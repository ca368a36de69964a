// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// How well the inverse kinematics of an arm find poses that it is known to reach.
struct InverseTrial {
  std::size_t poses = 0;
  std::size_t reached = 0;    ///< of these, poses with a solution, each of which leads back to the pose
  std::size_t recovered = 0;  ///< of these, poses among whose solutions are the joints that they were made by
  std::size_t regular = 0;    ///< of the poses, those made by joints at least 1.15 deg from any singularity
  std::size_t regular_recovered = 0;  ///< of these, poses among whose solutions are the joints
  double tip_error_mm = 0.0;          ///< greatest distance of a solution's nozzle from its pose
  double turn_error_rad = 0.0;        ///< the same of its rotation
  /// Whether a pose beyond any reach has no solution.
  bool ends = false;

  bool isPassed() const { return reached == poses && ends; }
};

/// Draws joints within their limits, the same in every run, takes the pose of the nozzle with each, and
/// solves for it. Solutions lead back within 1e-4 mm and 1e-7 rad.
InverseTrial tryInverse(const KinematicModel& arm, std::size_t poses);

}  // namespace lamina
