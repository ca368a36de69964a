// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/active_alarms.hpp"

#include <algorithm>
#include <iterator>

namespace lamina {
namespace {

constexpr double kFloodInterval = 1.0;  // [s] between two reports of one alarm

bool isGone(const ActiveAlarm& alarm) { return alarm.gone_s.has_value(); }

bool isAcknowledged(const ActiveAlarm& alarm) { return alarm.acknowledged_s.has_value(); }

bool isSettled(const ActiveAlarm& alarm) {
  const bool waits_for_somebody = isLatched(alarm) || alarmKind(alarm.id).cause == AlarmCause::Event;
  return isGone(alarm) && (!waits_for_somebody || isAcknowledged(alarm));
}

template <class Alarms>
auto findAlarm(Alarms& alarms, int id) {
  return std::find_if(alarms.begin(), alarms.end(), [id](const auto& alarm) { return alarm.id == id; });
}

}  // namespace

bool isLatched(const ActiveAlarm& alarm) { return alarm.category >= AlarmCategory::Hold; }

std::string sentenceOf(const ActiveAlarm& alarm) {
  return std::to_string(alarm.id) + ' ' + alarmKind(alarm.id).title +
         (alarm.message.empty() ? "" : ": " + alarm.message);
}

ActiveAlarms::Raised ActiveAlarms::raise(int id, double value, const std::string& message, double now_s) {
  const AlarmKind& kind = alarmKind(id);
  ActiveAlarm alarm{kind.id, kind.category, value, message, now_s, {}, {}, {}, 1};
  if (kind.cause == AlarmCause::Event) alarm.gone_s = now_s;
  const bool is_flooding = isFlooding(id, now_s);
  const auto last = findAlarm(last_reports_, id);
  const bool waits = !isGone(alarm) || isLatched(alarm);
  if (is_flooding && waits && last->is_outdated && !last->back_s) last->back_s = now_s;
  const auto active = findAlarm(alarms_, id);
  if (active == alarms_.end()) {
    alarms_.push_back(alarm);
    return is_flooding ? Raised::Flooding : Raised::Anew;
  }
  alarm.times = active->times + 1;
  alarm.raised_s = active->raised_s;
  *active = alarm;
  return is_flooding ? Raised::Flooding : Raised::Again;
}

void ActiveAlarms::end(int id, double now_s) {
  const auto alarm = findAlarm(alarms_, id);
  if (alarm == alarms_.end() || isGone(*alarm)) return;
  alarm->gone_s = now_s;
  LastReport& last = *findAlarm(last_reports_, id);
  last.is_outdated = true;
  last.back_s.reset();
  removeSettled();
}

bool ActiveAlarms::acknowledge(int id, const std::string& by, double now_s) {
  const auto alarm = findAlarm(alarms_, id);
  if (alarm == alarms_.end()) return false;
  alarm->acknowledged_s = now_s;
  alarm->acknowledged_by = by;
  LastReport& last = *findAlarm(last_reports_, id);
  last.is_outdated = true;
  last.back_s.reset();  // whoever acknowledges it has seen it come back
  removeSettled();
  return true;
}

void ActiveAlarms::forgetEvents() {
  const auto is_minor_event = [](const ActiveAlarm& alarm) { return !isLatched(alarm) && isGone(alarm); };
  alarms_.erase(std::remove_if(alarms_.begin(), alarms_.end(), is_minor_event), alarms_.end());
}

std::vector<ActiveAlarm> ActiveAlarms::from(AlarmCategory category) const {
  std::vector<ActiveAlarm> chosen;
  std::copy_if(alarms_.begin(), alarms_.end(), std::back_inserter(chosen),
               [category](const ActiveAlarm& alarm) { return alarm.category >= category; });
  return chosen;
}

std::optional<AlarmCategory> ActiveAlarms::gravest() const {
  std::optional<AlarmCategory> gravest;
  for (const ActiveAlarm& alarm : alarms_)
    if (!isGone(alarm)) gravest = std::max(gravest.value_or(AlarmCategory::Information), alarm.category);
  return gravest;
}

std::vector<ActiveAlarm> ActiveAlarms::takeReturned(double now_s) {
  std::vector<ActiveAlarm> returned;
  for (LastReport& last : last_reports_) {
    if (!last.back_s || now_s - last.at_s < kFloodInterval) continue;
    returned.push_back(*findAlarm(alarms_, last.id));  // its end would have cleared the time
    returned.back().raised_s = *last.back_s;
    last = {last.id, now_s, false, {}};
  }
  return returned;
}

void ActiveAlarms::removeSettled() {
  alarms_.erase(std::remove_if(alarms_.begin(), alarms_.end(), isSettled), alarms_.end());
}

bool ActiveAlarms::isFlooding(int id, double now_s) {
  const auto last = findAlarm(last_reports_, id);
  if (last == last_reports_.end()) {
    last_reports_.push_back({id, now_s, false, {}});
    return false;
  }
  if (now_s - last->at_s < kFloodInterval) return true;
  *last = {id, now_s, false, {}};
  return false;
}

}  // namespace lamina
