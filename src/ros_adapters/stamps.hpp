// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <cstdint>

namespace lamina {

/// Time from one stamp to another [s], negative if `to` is the earlier one. Accepts any two stamps: the
/// operators of ros::Time throw beyond 68 years, and a garbled stamp would end the node.
inline double secondsBetween(const ros::Time& from, const ros::Time& to) {
  constexpr double kNanosecond = 1e-9;
  const double seconds = static_cast<double>(to.sec) - static_cast<double>(from.sec);
  return seconds + kNanosecond * (static_cast<double>(to.nsec) - static_cast<double>(from.nsec));
}

/// The stamp that is a duration after another, or the first or last stamp that exists.
inline ros::Time stampAfter(const ros::Time& stamp, const ros::Duration& duration) {
  const std::int64_t earliest_ns = ros::TIME_MIN.toNSec();
  const std::int64_t latest_ns = ros::TIME_MAX.toNSec();
  const std::int64_t after_ns = static_cast<std::int64_t>(stamp.toNSec()) + duration.toNSec();
  ros::Time after;
  return after.fromNSec(static_cast<std::uint64_t>(std::clamp(after_ns, earliest_ns, latest_ns)));
}

}  // namespace lamina
