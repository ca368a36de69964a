// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "process_io_watch.hpp"

#include "lamina/base/number_text.hpp"
#include "names.hpp"

namespace lamina {

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
  if (!demand_.is_required) return {};
  const std::lock_guard<std::mutex> lock(mutex_);
  if (heard_.isZero()) return "process_io was not heard of";
  const double silent_s = (now - heard_).toSec();
  if (silent_s > demand_.silence_s)
    return "process_io has been silent for " + numberText(silent_s) + " s; expected word every " +
           numberText(demand_.silence_s) + " s at least";
  return last_.ready ? std::string() : "process_io is not ready: " + last_.reason;
}

}  // namespace lamina
