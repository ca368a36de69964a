// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/container/static_vector.hpp>

#include "kinematics/arm/seven_axes.hpp"

namespace lamina {

/// One solution of the inverse kinematics of an arm of seven axes for a pose and an arm angle. `branch` holds
/// the signs of `SevenSines` as bits: 4 if the shoulder sine is negative, 2 if the elbow sine is, 1 if the
/// wrist sine is. If several solutions share all signs, 8, 16, ... are added to those after the first.
struct SevenSolution {
  int branch = 0;
  SevenValues values;  ///< in (-pi, pi]
};
using SevenSolutions = boost::container::static_vector<SevenSolution, 8>;

/// Inverse kinematics of an arm of seven axes. If axes 1 to 3 meet in the shoulder and axes 5 to 7 in the
/// wrist, all solutions are found in closed form, and refined by Newton's method if the axes miss these
/// points or right angles by more than rounding, up to 0.5 mm. For any other arm, Newton's method follows the
/// solutions from the arm whose axes are shifted to these points; only solutions found this way are returned.
class SevenAxisInverse {
 public:
  /// @throws InvalidConfig as `sevenAxes`
  explicit SevenAxisInverse(const SerialChain& arm);

  /// Whether the axes of shoulder and wrist meet, within 0.5 mm.
  bool isSpherical() const { return !is_followed_; }

  /// The solutions for a pose and an arm angle [rad], in the order of branches. None out of reach.
  /// @param near  values from which joint 1 is kept if axes 1 and 3 are in line, and joint 5 if axes 5 and 7
  ///   are in line
  SevenSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle, double arm_angle,
                           const SevenValues& near) const;

  /// @return 0 if it is undefined
  double armAngle(const SevenValues& values) const;

  /// The least of the sines, in absolute value.
  double singularityMargin(const SevenValues& values) const;

 private:
  SevenAxes arm_;
  SevenAxes centred_;  ///< with its axes moved to shoulder and wrist
  double deviation_ = 0.0;
  bool is_followed_ = false;
};

}  // namespace lamina
