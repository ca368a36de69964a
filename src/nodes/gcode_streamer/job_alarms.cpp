// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job_alarms.hpp"

#include <ros/console.h>

#include <array>
#include <utility>

namespace lamina {
namespace {

constexpr std::array<std::pair<KeptCondition, std::uint16_t>, 4> kAlarms = {{{KeptCondition::Bed, 3201},
                                                                             {KeptCondition::Vacuum, 3202},
                                                                             {KeptCondition::Homing, 3203},
                                                                             {KeptCondition::Dryness, 3204}}};

std::vector<std::uint16_t> idsOfAll() {
  std::vector<std::uint16_t> ids;
  ids.reserve(kAlarms.size());
  for (const auto& [what, id] : kAlarms) ids.push_back(id);
  return ids;
}

}  // namespace

JobAlarms::JobAlarms(const ros::NodeHandle& node) : reports_(node, "gcode_streamer", idsOfAll()) {}

void JobAlarms::tell(const std::vector<JobLoss>& losses) {
  std::set<std::uint16_t> now;
  for (const JobLoss& loss : losses)
    for (const auto& [what, id] : kAlarms) {
      if (what != loss.what || !now.insert(id).second || raised_.count(id) > 0) continue;
      ROS_ERROR_STREAM(id << ": " << loss.reason);
      reports_.raise(id, loss.value, loss.reason);
    }
  for (const std::uint16_t id : raised_)
    if (now.count(id) == 0) reports_.end(id);
  raised_ = std::move(now);
}

}  // namespace lamina
