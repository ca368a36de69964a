// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "correction_reports.hpp"

#include <ros/ros.h>

#include "correction_messages.hpp"
#include "lamina/control/replanned_toolpath.hpp"
#include "lamina/control/supervision.hpp"
#include "names.hpp"

namespace lamina {

CorrectionReports::CorrectionReports(ros::NodeHandle& node)
    : applied_(node.advertise<lamina_msgs::AppliedCorrection>(names::kAppliedCorrection, 100)) {}

void CorrectionReports::publish(lamina_msgs::AppliedCorrection message) const {
  message.header.stamp = ros::Time::now();
  applied_.publish(message);
}

void CorrectionReports::tell(CorrectedStream& corrected) const {
  for (const auto& [toolpath_id, each] : corrected.takeDecisions()) {
    if (each.is_later) {
      ROS_DEBUG("layer %lu is trimmed from line %lu on", static_cast<unsigned long>(each.layer),
                static_cast<unsigned long>(each.from_line));
      continue;
    }
    // What is deposited by the coasting map has a digest, which leaves no place for why.
    const std::string reason = each.is_coasting ? std::string() : each.refusal;
    publish(toMessage({each.layer, each.waited_s, reason, {}}, toolpath_id, each.digest));
    if (each.is_coasting && !each.refusal.empty())
      ROS_WARN("layer %lu is deposited by its coasting map %s: %s", static_cast<unsigned long>(each.layer),
               each.digest.c_str(), each.refusal.c_str());
    else if (each.is_coasting)
      ROS_WARN("%d: no map of layer %lu within %.1f s: it is deposited by its coasting map %s",
               static_cast<int>(LoopAlarm::MapLate), static_cast<unsigned long>(each.layer), each.waited_s,
               each.digest.c_str());
    else if (!each.digest.empty())
      ROS_INFO("layer %lu is deposited by map %s", static_cast<unsigned long>(each.layer),
               each.digest.c_str());
    else if (!each.refusal.empty())
      ROS_WARN("layer %lu is deposited as planned: %s", static_cast<unsigned long>(each.layer),
               each.refusal.c_str());
    else if (each.layer > 0 || each.waited_s > 0.0)
      ROS_WARN("%d: no map of layer %lu within %.1f s: it is deposited as planned",
               static_cast<int>(LoopAlarm::MapLate), static_cast<unsigned long>(each.layer), each.waited_s);
  }
  const std::string failure = corrected.takeRecordFailure();
  if (!failure.empty()) ROS_WARN("the corrections are not recorded: %s", failure.c_str());
}

void CorrectionReports::tell(RecordedProgram& recorded, std::int32_t layer) const {
  for (; static_cast<std::int64_t>(recorded.next_planned) <= layer; ++recorded.next_planned) {
    publish(
        toMessage({recorded.next_planned, 0.0, "the job is gone on with from its record, without maps", {}},
                  recorded.toolpath_id, ""));
  }
}

void CorrectionReports::refuse(const std::string& plan_id, const CorrectedStream& corrected,
                               const std::string& reason) const {
  if (isPlanOf(plan_id, corrected.toolpathId())) publish(toMessage(refusedPlan(reason), plan_id, ""));
}

}  // namespace lamina
