// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <deque>
#include <optional>

namespace lamina {

/// Goals whose process has not arrived yet. A client sends the process of a goal with the goal's stamp, on
/// another connection; each connection keeps its order.
class AwaitedProcess {
 public:
  /// @param expected_s  longest time by which a goal's stamp may follow the last process; for later goals no
  ///   process is expected
  explicit AwaitedProcess(double expected_s) : expected_s_(expected_s) {}

  void hearGoal(const ros::Time& stamp);
  void hearProcess(const ros::Time& stamp);
  void forgetGoals() { goals_.clear(); }
  /// Stamp of the earliest goal without its process; nothing if none is awaited.
  std::optional<ros::Time> first() const;

 private:
  double expected_s_;
  ros::Time last_process_;           ///< zero before the first
  std::deque<ros::Time> goals_;      ///< without process, in the order they came
  std::deque<ros::Time> processes_;  ///< without goal
};

}  // namespace lamina
