// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/standing_conditions.hpp"

#include <algorithm>

namespace lamina {

void StandingConditions::raise(const RaisedAlarm& alarm) {
  if (!isCondition(alarm.alarm)) return;
  end(alarm.alarm);
  conditions_.push_back(alarm);
}

void StandingConditions::resume(const std::vector<RaisedAlarm>& stood) {
  for (const RaisedAlarm& alarm : stood) raise(alarm);
  is_resumed_ = true;
}

void StandingConditions::settle(const LoopStatus& status, const StandingAlarms& watched) {
  if (!isRunning(status.state)) return endAll();
  if (is_resumed_) return;
  if (!watched.isUp(LoopAlarm::Stuck)) end(LoopAlarm::Stuck);
  if (!watched.isUp(LoopAlarm::TimeOffset) && status.coasting_for != CoastingFor::TimeOffset)
    end(LoopAlarm::TimeOffset);
}

void StandingConditions::settleSight(const LoopStatus& status, const StandingAlarms& watched) {
  if (!watched.isUp(LoopAlarm::Silent) && !isSightLost(status)) end(LoopAlarm::Silent);
  if (!watched.isUp(LoopAlarm::NoTransform)) end(LoopAlarm::NoTransform);
}

void StandingConditions::end(LoopAlarm alarm) {
  conditions_.erase(std::remove_if(conditions_.begin(), conditions_.end(),
                                   [alarm](const RaisedAlarm& each) { return each.alarm == alarm; }),
                    conditions_.end());
}

}  // namespace lamina
