// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "process_io_watch.hpp"

#include "lamina/base/number_text.hpp"
#include "names.hpp"

namespace lamina {

std::string processFault(const ProcessIoDemand& demand, const lamina_msgs::ProcessReady& last,
                         const ros::Time& heard, const ros::Time& now) {
  if (!demand.is_required) return {};
  if (heard.isZero()) return "process_io was not heard of";
  const double silent_s = (now - heard).toSec();
  if (silent_s > demand.silence_s)
    return "process_io has been silent for " + numberText(silent_s) + " s; expected word every " +
           numberText(demand.silence_s) + " s at least";
  if (silent_s < -demand.silence_s)
    return "process_io was last heard " + numberText(-silent_s) +
           " s ahead of ROS time, which has gone back; expected word since";
  return last.ready ? std::string() : "process_io is not ready: " + last.reason;
}

ProcessIoWatch::ProcessIoWatch(ros::NodeHandle& node, const ProcessIoDemand& demand) : demand_(demand) {
  if (!demand.is_required) return;
  const boost::function<void(const lamina_msgs::ProcessReadyConstPtr&)> on_ready =
      [this](const auto& message) {
        const std::lock_guard<std::mutex> lock(mutex_);
        last_ = *message;
        heard_ = ros::Time::now();
      };
  ready_ = node.subscribe<lamina_msgs::ProcessReady>(names::kProcessReady, 1, on_ready);
}

std::string ProcessIoWatch::fault(const ros::Time& now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return processFault(demand_, last_, heard_, now);
}

}  // namespace lamina
