// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/queue_follower.hpp"

#include <utility>

#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr char kQueue[] = "queue";
constexpr double kLookInterval = 1.0;  // [s]

/// What has to be so before the plate is prepared for the next part.
bool isForReset(const UnmetGuard& guard) {
  constexpr int kNotRemoved = 1203;
  constexpr int kNoJob = 1302;
  return guard.code == kNotRemoved || guard.code == kNoJob;
}

std::string reasonsAgainst(UnitCommand command, const UnitStatus& unit,
                           const std::vector<UnmetGuard>& unmet) {
  const std::vector<ActiveAlarm> alarms = unit.alarms.from(AlarmCategory::Suspend);
  std::vector<std::string> reasons;
  reasons.reserve(alarms.size() + unmet.size());
  for (const ActiveAlarm& alarm : alarms)
    reasons.push_back("alarm " + std::to_string(alarm.id) +
                      (alarm.message.empty() ? "" : ": " + alarm.message));
  for (const UnmetGuard& guard : unmet)
    if (command != UnitCommand::Reset || isForReset(guard)) reasons.push_back(guard.sentence);
  return listed(reasons, "; ");
}

}  // namespace

std::optional<UnitCommand> QueueFollower::observe(const UnitStatus& unit) {
  const bool was_reset_by_queue = std::exchange(is_reset_by_queue_, false);
  if (rule_ == QueueAdvance::Ask || unit.mode != kProduction || refused_after_ == unit.sequence)
    return std::nullopt;
  if (unit.state == UnitState::Complete) return UnitCommand::Reset;
  if (unit.state != UnitState::Resetting && unit.state != UnitState::Idle) return std::nullopt;
  is_reset_by_queue_ = was_reset_by_queue;
  if (unit.state == UnitState::Resetting || !was_reset_by_queue) return std::nullopt;
  return UnitCommand::Start;
}

void QueueFollower::follow(ProductionCell& cell, const std::function<StartOutlook()>& look, CellTime now) {
  const auto turn = observe(cell.status());
  if (!turn) {
    if (refused_after_ != cell.status().sequence) waits_for_.clear();
    return;
  }
  if (looked_s_ && now.steady_s - *looked_s_ < kLookInterval) return;
  looked_s_ = now.steady_s;
  StartOutlook outlook = look();
  for (UnmetGuard& guard : cell.againstNext(outlook.found)) outlook.unmet.push_back(std::move(guard));
  waits_for_ = reasonsAgainst(*turn, cell.status(), outlook.unmet);
  if (!waits_for_.empty()) return;
  const std::uint32_t before = cell.status().sequence;
  const CommandAnswer answer =
      cell.command({*turn, kQueue, before, {}}, outlook.found, CutOffJob::Undecided, now);
  if (answer.result == CommandResult::Accepted) {
    is_reset_by_queue_ = *turn == UnitCommand::Reset;
    looked_s_.reset();
    return;
  }
  refused_after_ = before;
  waits_for_ = answer.reason;
}

}  // namespace lamina
