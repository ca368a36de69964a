// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "process_queue.hpp"

#include "joint_messages.hpp"

namespace lamina {

void ProcessQueue::accept(const lamina_msgs::ProcessTrajectory& message) {
  while (!points_.empty() && points_.back().from >= message.header.stamp) points_.pop_back();
  for (const auto& point : message.points)
    points_.push_back({message.header.stamp + point.time_from_start, fromMessage(point)});
  valid_until_ = message.header.stamp + message.valid_for;
}

ProcessSignals ProcessQueue::at(const ros::Time& now) {
  while (points_.size() > 1 && points_[1].from <= now) points_.pop_front();
  if (points_.empty() || now < points_.front().from || now > valid_until_) return safeSignals();
  ProcessSignals signals = points_.front().signals;
  if (points_.size() < 2) return signals;
  // The flow goes in proportion from point to point; switches stay as they are until the next.
  const double span_s = (points_[1].from - points_[0].from).toSec();
  const double share = span_s > 0.0 ? (now - points_[0].from).toSec() / span_s : 0.0;
  signals.flow_mm3_s += share * (points_[1].signals.flow_mm3_s - signals.flow_mm3_s);
  return signals;
}

}  // namespace lamina
