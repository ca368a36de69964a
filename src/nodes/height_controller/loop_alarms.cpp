// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop_alarms.hpp"

#include <ros/ros.h>

#include <array>

#include "lamina/control/run/standing_alarms.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr std::array<LoopAlarm, 4> kConditions = {LoopAlarm::Silent, LoopAlarm::NoTransform, LoopAlarm::Stuck,
                                                  LoopAlarm::TimeOffset};

lamina_msgs::AlarmReport endOf(LoopAlarm alarm) {
  lamina_msgs::AlarmReport report;
  report.header.stamp = ros::Time::now();
  report.id = static_cast<std::uint16_t>(alarm);
  report.source = "height_controller";
  report.is_gone = true;
  return report;
}

/// Without a value: the reason names those that there are, with their units.
lamina_msgs::AlarmReport reportOf(const RaisedAlarm& alarm) {
  lamina_msgs::AlarmReport report = endOf(alarm.alarm);
  report.is_gone = false;
  report.message = alarm.reason;
  return report;
}

}  // namespace

LoopAlarms::LoopAlarms(ros::NodeHandle node)
    : reports_(node.advertise<lamina_msgs::AlarmReport>(
          names::kAlarmReports, 100, [this](const ros::SingleSubscriberPublisher& listener) {
            const std::lock_guard<std::mutex> lock(mutex_);
            // Those of a node that died are not raised any more.
            for (const LoopAlarm alarm : kConditions) {
              const auto raised = raised_.find(alarm);
              listener.publish(raised == raised_.end() ? endOf(alarm) : reportOf(raised->second));
            }
          })) {}

void LoopAlarms::raise(const RaisedAlarm& alarm) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (isCondition(alarm.alarm)) raised_[alarm.alarm] = alarm;
  reports_.publish(reportOf(alarm));
}

void LoopAlarms::settle(const std::vector<RaisedAlarm>& standing) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto raised = raised_.begin(); raised != raised_.end();) {
    if (isAmong(standing, raised->first)) {
      ++raised;
      continue;
    }
    reports_.publish(endOf(raised->first));
    raised = raised_.erase(raised);
  }
}

}  // namespace lamina
