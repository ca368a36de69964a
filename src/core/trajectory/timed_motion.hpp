// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "lamina/trajectory/timed_path.hpp"
#include "trajectory/process_schedule.hpp"
#include "trajectory/speed_plan.hpp"

namespace lamina {

/// A curve with speeds along it; the speeds refer to the curve.
class TimedMotion {
 public:
  TimedMotion(JointStations stations, const KinematicModel& model, const TimingSettings& settings);
  TimedMotion(const TimedMotion&) = delete;
  TimedMotion& operator=(const TimedMotion&) = delete;

  const TimingSettings& settings() const { return settings_; }
  const JointCurve& curve() const { return curve_; }
  const SpeedPlan& plan() const { return plan_; }
  const ProcessSchedule& schedule() const { return schedule_; }
  /// The greatest speeds if the toolpath's feeds are multiplied by a factor. Takes linear time.
  /// @param feed_share  (0, inf)
  std::unique_ptr<const SpeedPlan> planAt(double feed_share) const;
  /// Time over which the motion is averaged to limit jerk [s].
  double averaging() const;

 private:
  TimingSettings settings_;
  JointCurve curve_;
  SpeedPlan plan_;
  ProcessSchedule schedule_;
};

}  // namespace lamina
