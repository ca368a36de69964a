// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job_alarms.hpp"

#include <ros/ros.h>

#include <array>
#include <utility>

#include "names.hpp"

namespace lamina {
namespace {

constexpr std::array<std::pair<KeptCondition, int>, 4> kAlarms = {{{KeptCondition::Bed, 3201},
                                                                   {KeptCondition::Vacuum, 3202},
                                                                   {KeptCondition::Homing, 3203},
                                                                   {KeptCondition::Dryness, 3204}}};

lamina_msgs::AlarmReport reportOf(int id) {
  lamina_msgs::AlarmReport report;
  report.header.stamp = ros::Time::now();
  report.id = static_cast<std::uint16_t>(id);
  report.source = "gcode_streamer";
  report.is_gone = true;
  return report;
}

lamina_msgs::AlarmReport reportOf(int id, const JobLoss& loss) {
  lamina_msgs::AlarmReport report = reportOf(id);
  report.is_gone = false;
  report.value = loss.value;
  report.message = loss.reason;
  return report;
}

}  // namespace

JobAlarms::JobAlarms(ros::NodeHandle node)
    : reports_(node.advertise<lamina_msgs::AlarmReport>(
          names::kAlarmReports, 100, [this](const ros::SingleSubscriberPublisher& listener) {
            const std::lock_guard<std::mutex> lock(mutex_);
            // Those of a node that died are not raised any more.
            for (const auto& [what, id] : kAlarms) {
              const auto raised = raised_.find(id);
              listener.publish(raised == raised_.end() ? reportOf(id) : reportOf(id, raised->second));
            }
          })) {}

void JobAlarms::tell(const std::vector<JobLoss>& losses) {
  std::map<int, JobLoss> now;
  for (const JobLoss& loss : losses)
    for (const auto& [what, id] : kAlarms)
      if (what == loss.what) now[id] = loss;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [id, loss] : now) {
    if (raised_.count(id) > 0) continue;
    ROS_ERROR_STREAM(id << ": " << loss.reason);
    reports_.publish(reportOf(id, loss));
  }
  for (const auto& [id, loss] : raised_)
    if (now.count(id) == 0) reports_.publish(reportOf(id));
  raised_ = std::move(now);
}

}  // namespace lamina
