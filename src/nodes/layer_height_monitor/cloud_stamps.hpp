// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstddef>
#include <deque>

namespace lamina {

/// Stamps of clouds in the order in which they came, of one sensor or of several. A single stamp far ahead,
/// of a clock that is set or garbled, says nothing of what has come.
class CloudStamps {
 public:
  static constexpr std::size_t kRemembered = 32;

  /// A cloud has come; one without a stamp has no effect.
  void add(const ros::Time& stamp);
  /// Whether clouds have come up to a stamp: that of one of the last `kRemembered`, or not after two that
  /// came in turn.
  bool haveReached(const ros::Time& stamp) const;

 private:
  std::deque<ros::Time> last_;
  ros::Time reached_;  ///< latest stamp that is not after two in turn
};

}  // namespace lamina
