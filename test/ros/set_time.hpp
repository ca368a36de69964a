// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

namespace lamina::test {

/// ROS time of a test without a master, which sets it. Once it is over, ROS time is that of the system.
class SetTime {
 public:
  SetTime() { ros::Time::init(); }
  ~SetTime() { ros::Time::init(); }
  SetTime(const SetTime&) = delete;
  SetTime& operator=(const SetTime&) = delete;

  void set(const ros::Time& time) const { ros::Time::setNow(time); }
  void set(double time_s) const { set(ros::Time(time_s)); }
};

}  // namespace lamina::test
