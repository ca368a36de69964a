// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <optional>
#include <string>

#include "driver_settings.hpp"

namespace lamina {

/// Detects silence of a controller.
///
/// By arrival, the time since the last report counts, but only between frequent calls of `look`: a driver
/// that did not run itself cannot know that the controller was silent. By stamps, the gap between the stamps
/// of two reports counts, and the time since the last arrival is compared only with the limit of a lost
/// connection.
class ReportWatch {
 public:
  /// @param begin  from when on reports are expected
  ReportWatch(const TrackingLimits& limits, double connection_s, const ros::Time& begin);

  /// States that a report with that stamp has arrived.
  void hear(const ros::Time& stamp, const ros::Time& now);
  /// States that reports are expected from now on, and were not before.
  void restart(const ros::Time& now);
  /// Checks for silence; to be called continually.
  /// @return what is wrong; nothing while the controller is not silent
  std::optional<std::string> look(const ros::Time& now);

 private:
  TrackingLimits limits_;
  double connection_s_;
  ros::Time looked_at_;
  ros::Time stamp_;         ///< of the last report; zero before the first
  double unheard_s_ = 0.0;  ///< time since the last report that was covered by calls of `look`
  double gap_s_ = 0.0;      ///< greatest, between two stamps
};

}  // namespace lamina
