// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Deviations of a kinematic model from its planned positions, report by report.
class Tracking {
 public:
  explicit Tracking(const KinematicModel& model)
      : model_(model), joints_(JointValues::Zero(static_cast<Eigen::Index>(model.joints().size()))) {}

  /// Adds a report of the controller.
  void add(const JointValues& wanted, const JointValues& actual);

  const JointValues& joints() const { return joints_; }  ///< actual less wanted, of the last report; 0 before
  double tip() const { return tip_mm_; }                 ///< of the last report [mm]
  double worstTip() const { return worst_tip_mm_; }      ///< [mm]
  double rmsTip() const;                                 ///< [mm]

  /// Why the last report ends a job: the tip is farther than `most_mm` from its planned position. 0 is no
  /// limit.
  std::optional<std::string> deviation(double most_mm) const;

 private:
  const KinematicModel& model_;
  JointValues joints_;
  std::size_t reports_ = 0;
  double tip_mm_ = 0.0;
  double worst_tip_mm_ = 0.0;
  double squares_mm2_ = 0.0;
};

/// How well a controller was fed.
struct Feeding {
  std::size_t starvations = 0;  ///< number of times that it had nothing left to run before the end
  double least_queued_s = 0.0;  ///< of motion, while there was more to send
};

}  // namespace lamina
