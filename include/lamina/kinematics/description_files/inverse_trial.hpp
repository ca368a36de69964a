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
  /// Whether a pose far out of reach has no solution, as it should.
  bool ends = false;

  bool isPassed() const { return reached == poses && ends; }
};

/// Draws joint values within their limits, the same in every run, and solves for the pose of the nozzle at
/// each. A solution leads back to the pose if its own pose agrees within 1e-4 mm and 1e-7 rad.
InverseTrial tryInverse(const KinematicModel& arm, std::size_t poses);

}  // namespace lamina
