// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "alarm_reports.hpp"

#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/time.h>

#include <algorithm>
#include <utility>

#include "names.hpp"

namespace lamina {

AlarmReports::AlarmReports(ros::NodeHandle node, std::string source, std::vector<std::uint16_t> conditions)
    : source_(std::move(source)),
      conditions_(std::move(conditions)),
      reports_(node.advertise<lamina_msgs::AlarmReport>(
          names::kAlarmReports, 100, [this](const ros::SingleSubscriberPublisher& listener) {
            const std::lock_guard<std::mutex> lock(mutex_);
            for (const std::uint16_t id : conditions_) {
              const auto standing = standing_.find(id);
              lamina_msgs::AlarmReport report = standing == standing_.end() ? endOf(id) : standing->second;
              report.header.stamp = ros::Time::now();
              listener.publish(report);
            }
          })) {}

lamina_msgs::AlarmReport AlarmReports::endOf(std::uint16_t id) const {
  lamina_msgs::AlarmReport report;
  report.header.stamp = ros::Time::now();
  report.id = id;
  report.source = source_;
  report.is_gone = true;
  return report;
}

void AlarmReports::raise(std::uint16_t id, double value, const std::string& message) {
  lamina_msgs::AlarmReport report = endOf(id);
  report.is_gone = false;
  report.value = value;
  report.message = message;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (std::find(conditions_.begin(), conditions_.end(), id) != conditions_.end()) standing_[id] = report;
  reports_.publish(report);
}

bool AlarmReports::stands(std::uint16_t id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return standing_.count(id) > 0;
}

void AlarmReports::end(std::uint16_t id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (standing_.erase(id) > 0) reports_.publish(endOf(id));
}

}  // namespace lamina
