// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// How far what turns with the nozzle may lean before it is in the bed, a plane without end.
class HeadOverBed {
 public:
  /// @throws InvalidConfig as `linkBodies`
  explicit HeadOverBed(const KinematicModel& model);

  /// Greatest lean from upright, in whole degrees up to 120, at which, and below which, nothing of the head
  /// is deeper in the bed than the tolerance, wherever it leans to; 0 if it is at every lean.
  double greatestLeanDeg(double tip_mm, double tolerance_mm) const;

 private:
  std::vector<double>
      depth_mm_;  ///< by degree of lean: of the head below the tip, no less than at smaller leans
};

}  // namespace lamina
