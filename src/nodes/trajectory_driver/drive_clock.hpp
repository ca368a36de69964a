// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <optional>

namespace lamina {

/// By which ROS time may be corrected while a motion follows it [s].
inline constexpr double kSetBack = 0.05;

/// An instant by two clocks: ROS time, by which points are followed and which may be set, and one that only
/// goes on.
struct DriveInstant {
  ros::Time ros;
  /// Nothing in simulated time, which goes at a speed of its own, or if the host is too busy to read both
  /// clocks at once.
  std::optional<double> steady_s;
};

/// This instant.
DriveInstant presentInstant();

}  // namespace lamina
