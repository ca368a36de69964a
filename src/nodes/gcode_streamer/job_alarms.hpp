// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <map>
#include <mutex>
#include <vector>

#include "lamina/startup/job_watch.hpp"
#include "messages.hpp"

namespace lamina {

/// The alarms 3201 to 3204 of the job under way, on `alarm_reports`. Whoever begins to listen gets those that
/// are there.
class JobAlarms {
 public:
  explicit JobAlarms(ros::NodeHandle node);

  /// What is lost just now, none of it before a job and after it.
  void tell(const std::vector<JobLoss>& losses);

 private:
  std::mutex mutex_;
  std::map<int, JobLoss> raised_;
  ros::Publisher reports_;
};

}  // namespace lamina
