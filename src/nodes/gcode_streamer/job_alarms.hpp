// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <set>
#include <vector>

#include "alarm_reports.hpp"
#include "lamina/startup/job_watch.hpp"

namespace lamina {

/// The alarms 3201 to 3204 of the job under way, for the unit. To be called from one thread.
class JobAlarms {
 public:
  explicit JobAlarms(const ros::NodeHandle& node);

  /// Reports the present losses; there are none before and after a job.
  void tell(const std::vector<JobLoss>& losses);

 private:
  std::set<std::uint16_t> raised_;
  AlarmReports reports_;
};

}  // namespace lamina
