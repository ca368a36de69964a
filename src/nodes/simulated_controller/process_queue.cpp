// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "process_queue.hpp"

#include <algorithm>

#include "joint_messages.hpp"
#include "lamina/process_io/process_plan.hpp"
#include "stamps.hpp"

namespace lamina {

void ProcessQueue::accept(const lamina_msgs::ProcessTrajectory& message) {
  while (!points_.empty() && points_.back().from >= message.header.stamp) points_.pop_back();
  for (const auto& point : message.points)
    points_.push_back({stampAfter(message.header.stamp, point.time_from_start), fromMessage(point)});
  valid_until_ = stampAfter(message.header.stamp, message.valid_for);
  if (message.points.empty()) return;
  const ros::Time last = stampAfter(message.header.stamp, message.points.back().time_from_start);
  valid_until_ = std::min(valid_until_, stampAfter(last, ros::Duration(ProcessPlan::kLongestHold)));
}

ProcessSignals ProcessQueue::at(const ros::Time& now) {
  while (points_.size() > 1 && points_[1].from <= now) points_.pop_front();
  if (points_.empty() || now < points_.front().from || now > valid_until_) return safeSignals();
  ProcessSignals signals = points_.front().signals;
  if (points_.size() < 2) return signals;
  const double span_s = secondsBetween(points_[0].from, points_[1].from);
  const double share = span_s > 0.0 ? secondsBetween(points_[0].from, now) / span_s : 0.0;
  return between(signals, points_[1].signals, share);
}

}  // namespace lamina
