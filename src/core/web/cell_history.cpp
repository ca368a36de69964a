// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/cell_history.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr std::size_t kMostSamples = 600;
constexpr std::size_t kMostEvents = 500;
constexpr double kLongestSilence = 5.0;  // [s] of a machine at work, which speaks ten times a second

template <class Row, class Key>
const Row* rowOf(const std::vector<Row>& rows, const Key& key, Key Row::*field) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.*field == key; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

ShownMachine presentMachine(const CellSnapshot& seen, const CellTime& now) {
  ShownMachine machine = seen.machine;
  if (seen.machine_heard_s && now.steady_s - *seen.machine_heard_s <= kLongestSilence) return machine;
  machine.nozzle_degc = machine.nozzle_target_degc = kNotMeasured;
  machine.bed_degc = machine.bed_target_degc = kNotMeasured;
  return machine;
}

void CellHistory::observe(const CellSnapshot& seen, const CellTime& now) {
  if (!seen.heard_s) return;
  estimate(seen, now.steady_s);
  if (!sampled_s_ || now.steady_s - *sampled_s_ >= 1.0) {
    sampled_s_ = now.steady_s;
    const ShownMachine machine = presentMachine(seen, now);
    samples_.push_back({now.utc_s, machine.nozzle_degc, machine.bed_degc, seen.unit.fraction});
    if (samples_.size() > kMostSamples) samples_.pop_front();
  }
  compare(seen, now.utc_s);
  before_ = seen;
}

void CellHistory::estimate(const CellSnapshot& seen, double steady_s) {
  const auto& job = seen.unit.job;
  if (job && seen.unit.state == UnitState::Execute)
    left_.observe(steady_s, job->id, seen.unit.fraction);
  else if (job)
    left_.pause(steady_s);
  else
    left_ = TimeLeft();
}

std::optional<LeftEstimate> CellHistory::left() const { return left_.estimate(); }

void CellHistory::compare(const CellSnapshot& seen, double utc_s) {
  const bool is_first = !before_;
  if (is_first || before_->unit.sequence != seen.unit.sequence) {
    std::string text = toString(seen.unit.state);
    if (seen.unit.stop_reason != 0 && seen.unit.state != UnitState::Execute)
      text += ": " + seen.unit.stop_message;
    add(utc_s, "state", text);
  }
  if (!is_first && before_->unit.mode != seen.unit.mode) add(utc_s, "state", "mode " + seen.unit.mode_name);
  compareAlarms(seen, utc_s);
  compareQueue(seen, utc_s);
  if (seen.loop && (is_first || !before_->loop || before_->loop->state != seen.loop->state ||
                    before_->loop->reason != seen.loop->reason))
    add(utc_s, "loop", seen.loop->state + (seen.loop->reason.empty() ? "" : ": " + seen.loop->reason));
  for (const ShownStep& step : seen.startup) {
    const ShownStep* former = is_first ? nullptr : rowOf(before_->startup, step.name, &ShownStep::name);
    if (former == nullptr || former->state != step.state)
      add(utc_s, "start-up",
          step.name + " is " + step.state + (step.reason.empty() ? "" : ": " + step.reason));
  }
}

void CellHistory::compareAlarms(const CellSnapshot& seen, double utc_s) {
  static const std::vector<ShownAlarm> kNone;
  const std::vector<ShownAlarm>& former = before_ ? before_->alarms : kNone;
  for (const ShownAlarm& alarm : seen.alarms) {
    const ShownAlarm* known = rowOf(former, alarm.id, &ShownAlarm::id);
    const std::string name = std::to_string(alarm.id) + " " + alarm.title;
    if (known == nullptr) add(utc_s, "alarm", name + ": " + alarm.message);
    if (alarm.is_acknowledged && (known == nullptr || !known->is_acknowledged))
      add(utc_s, "alarm", name + " acknowledged by " + alarm.acknowledged_by);
  }
  for (const ShownAlarm& alarm : former)
    if (rowOf(seen.alarms, alarm.id, &ShownAlarm::id) == nullptr)
      add(utc_s, "alarm", std::to_string(alarm.id) + " " + alarm.title + " is over");
}

void CellHistory::compareQueue(const CellSnapshot& seen, double utc_s) {
  if (!before_) return;
  for (const ShownJob& job : seen.queue) {
    const ShownJob* known = rowOf(before_->queue, job.id, &ShownJob::id);
    const std::string name = "job " + std::to_string(job.id) + " " + job.name;
    if (known == nullptr)
      add(utc_s, "job", name + " put into the queue by " + job.created_by);
    else if (known->state != job.state)
      add(utc_s, "job", name + " is " + toString(job.state));
  }
  for (const ShownJob& job : before_->queue)
    if (rowOf(seen.queue, job.id, &ShownJob::id) == nullptr)
      add(utc_s, "job", "job " + std::to_string(job.id) + " " + job.name + " has left the queue");
}

void CellHistory::add(double utc_s, const char* kind, const std::string& text) {
  events_.push_back({++last_event_, utc_s, kind, text});
  if (events_.size() > kMostEvents) events_.pop_front();
}

}  // namespace lamina
