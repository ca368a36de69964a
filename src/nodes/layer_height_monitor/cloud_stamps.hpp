// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstddef>
#include <deque>

namespace lamina {

/// Stamps of clouds of one or several sensors, in the order of arrival. A single stamp far ahead, from a
/// clock that was set or a garbled message, is no evidence of what has arrived.
class CloudStamps {
 public:
  static constexpr std::size_t kRemembered = 32;

  /// Adds an arrived cloud; a cloud without a stamp has no effect.
  void add(const ros::Time& stamp);
  /// Whether clouds have reached a stamp: it is that of one of the last `kRemembered`, or not later than two
  /// consecutive ones.
  bool haveReached(const ros::Time& stamp) const;

 private:
  std::deque<ros::Time> last_;
  ros::Time reached_;  ///< latest stamp that is not later than two consecutive ones
};

}  // namespace lamina
