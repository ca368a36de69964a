// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop_alarms.hpp"

#include <array>
#include <cstdint>

#include "lamina/control/run/standing_alarms.hpp"

namespace lamina {
namespace {

constexpr std::array<LoopAlarm, 4> kConditions = {LoopAlarm::Silent, LoopAlarm::NoTransform, LoopAlarm::Stuck,
                                                  LoopAlarm::TimeOffset};

std::uint16_t idOf(LoopAlarm alarm) { return static_cast<std::uint16_t>(alarm); }

std::vector<std::uint16_t> conditions() {
  std::vector<std::uint16_t> ids;
  ids.reserve(kConditions.size());
  for (const LoopAlarm alarm : kConditions) ids.push_back(idOf(alarm));
  return ids;
}

}  // namespace

LoopAlarms::LoopAlarms(const ros::NodeHandle& node) : reports_(node, "height_controller", conditions()) {}

/// Without a value: the reason names those that there are, with their units.
void LoopAlarms::raise(const RaisedAlarm& alarm) { reports_.raise(idOf(alarm.alarm), 0.0, alarm.reason); }

void LoopAlarms::settle(const std::vector<RaisedAlarm>& standing) {
  for (const RaisedAlarm& alarm : standing)
    if (!reports_.stands(idOf(alarm.alarm))) raise(alarm);
  for (const LoopAlarm alarm : kConditions)
    if (!isAmong(standing, alarm)) reports_.end(idOf(alarm));
}

}  // namespace lamina
