// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <functional>

namespace lamina::test {

constexpr double kPatience = 240.0;  // s: far above what anything takes, for loaded machines

constexpr double kAfterFailure = 5.0;  // s: what fails once must not end as a time-out of the whole test

/// Lets callbacks run until something is true.
/// @return false if it is not within `kPatience`; within `kAfterFailure` if the test has failed already
inline bool waitUntil(const std::function<bool()>& is_true) {
  const double patience_s = testing::Test::HasFailure() ? kAfterFailure : kPatience;
  const ros::WallTime give_up = ros::WallTime::now() + ros::WallDuration(patience_s);
  // What was true once is not asked again: it may have gone on since.
  while (!is_true()) {
    if (ros::WallTime::now() >= give_up) return false;
    ros::spinOnce();
    ros::WallDuration(0.01).sleep();
  }
  return true;
}

}  // namespace lamina::test
