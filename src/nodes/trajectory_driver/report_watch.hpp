// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <optional>
#include <string>

#include "driver_settings.hpp"

namespace lamina {

/// Notices when a controller falls silent.
///
/// By arrival, the time since the last report counts while somebody looks: a driver that did not run itself
/// cannot know that the controller was silent. By stamps, the gap between the stamps of two reports counts,
/// and the time since the last one came only against the limit of a lost connection.
class ReportWatch {
 public:
  /// @param begin  from when on reports are expected
  ReportWatch(const TrackingLimits& limits, double connection_s, const ros::Time& begin);

  /// A report with that stamp has come.
  void hear(const ros::Time& stamp, const ros::Time& now);
  /// Reports are expected from now on: there were none to come before.
  void restart(const ros::Time& now);
  /// Somebody looks; to be called all the time.
  /// @return what is wrong; nothing while the controller is not silent
  std::optional<std::string> look(const ros::Time& now);

 private:
  TrackingLimits limits_;
  double connection_s_;
  ros::Time looked_at_;
  ros::Time stamp_;         ///< of the last report; zero before the first
  double unheard_s_ = 0.0;  ///< since the last report came, as far as somebody looked
  double gap_s_ = 0.0;      ///< greatest, between two stamps
};

}  // namespace lamina
