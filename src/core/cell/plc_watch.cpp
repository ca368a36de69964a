// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/plc_watch.hpp"

#include <algorithm>
#include <utility>

namespace lamina {
namespace {

constexpr int kPlcSilent = 2101;
constexpr int kEmergencyStopReported = 1207;
constexpr int kGuardOpened = 1208;
constexpr double kLongestLinkSilence = 2.0;  // [s] of a link that speaks twice a second

bool restsBetweenJobs(UnitState state) {
  switch (state) {
    case UnitState::Stopped:
    case UnitState::Resetting:
    case UnitState::Idle:
    case UnitState::Completing:
    case UnitState::Complete:
    case UnitState::Aborted:
    case UnitState::Clearing:
      return true;
    default:
      return false;
  }
}

bool isOnTheWay(UnitState state) {
  return state == UnitState::Starting || state == UnitState::Unholding || state == UnitState::Unsuspending;
}

bool isLost(PlcHeartbeat heartbeat) {
  return heartbeat == PlcHeartbeat::Lost || heartbeat == PlcHeartbeat::Abandoned;
}

/// Whether the heartbeat comes, armed or not.
bool comes(const PlcInterlocks& found) { return found.is_alive || found.is_beating; }

bool isWaiting(UnitState state) { return state == UnitState::Held || state == UnitState::Suspended; }

bool isSuspension(int alarm) { return alarm >= 1201 && alarm <= 1206; }

/// These stand in the way of a part that is being printed; 1203 and 1206 only of the next one.
bool suspends(int alarm) { return alarm == 1201 || alarm == 1202 || alarm == 1204 || alarm == 1205; }

}  // namespace

void PlcWatch::hear(const PlcReport& report, double now_s) {
  const auto before = std::exchange(report_, report);
  heard_s_ = now_s;
  if (report.heartbeat == PlcHeartbeat::Good) is_armed_ = true;
  hearSilence(report, before ? before->heartbeat : PlcHeartbeat::Unarmed);
  if (!before) return;
  const bool is_trusted = !isLost(report.heartbeat) && report.is_plate_written && before->is_plate_written;
  is_removal_new_ = is_removal_new_ || (is_trusted && report.is_part_removed && !before->is_part_removed);
  is_guard_opened_ =
      is_guard_opened_ || (comes(report.interlocks) && !report.is_guard_closed && before->is_guard_closed);
}

/// What the first report says is new: nobody tells whether a cell that died had acted on it.
void PlcWatch::hearSilence(const PlcReport& report, PlcHeartbeat before) {
  if (report.on_silence == WatchdogAction::Stop && isLost(report.heartbeat) && !isLost(before))
    is_stop_due_ = true;
  if (report.heartbeat != PlcHeartbeat::Abandoned)
    is_abandoned_ = false;
  else if (report.on_silence != WatchdogAction::None && before != PlcHeartbeat::Abandoned)
    is_abandoned_ = true;
}

PlcInterlocks PlcWatch::interlocks(double now_s) const {
  PlcInterlocks found = report_ ? report_->interlocks : PlcInterlocks{};
  const bool is_link_heard = now_s - heard_s_ <= kLongestLinkSilence;
  found.is_alive = found.is_alive && is_link_heard;
  found.is_beating = found.is_beating && is_link_heard;
  found.is_silent = !comes(found) && (is_armed_ || (report_ && isLost(report_->heartbeat)));
  return found;
}

PlcDemands PlcWatch::demands(const UnitStatus& unit, double now_s) {
  PlcDemands demands;
  const std::vector<PlcAlarm> present = causes(unit, now_s);
  std::set<int> there;
  for (const PlcAlarm& alarm : present) {
    there.insert(alarm.id);
    if (raised_.count(alarm.id) == 0) demands.raised.push_back(alarm);
  }
  for (const int id : raised_)
    if (there.count(id) == 0) demands.ended.push_back(id);
  raised_ = std::move(there);
  if (std::exchange(is_guard_opened_, false) && !restsBetweenJobs(unit.state) && !isWaiting(unit.state))
    demands.raised.push_back({kGuardOpened, "the PLC reports the guard open"});
  demands.is_part_removed = std::exchange(is_removal_new_, false) && restsBetweenJobs(unit.state);
  if (demands.raised.empty() && demands.ended.empty()) demands.command = ordered(unit);
  return demands;
}

/// What is there now and counts as an alarm. While the PLC is not heard, what it said last stays as it is.
std::vector<PlcAlarm> PlcWatch::causes(const UnitStatus& unit, double now_s) {
  std::vector<PlcAlarm> present;
  const PlcInterlocks found = interlocks(now_s);
  const PlcNeed need = settings_.is_required ? PlcNeed::Required : PlcNeed::None;
  const bool is_heard = isHeard(found, need);
  for (const UnmetGuard& guard : againstPlc(found, need)) {
    const bool is_raised = raised_.count(guard.code) != 0;
    const bool runs =
        unit.state == UnitState::Execute || (settings_.holds_on_the_way && isOnTheWay(unit.state));
    const bool counts = runs || (is_raised && !restsBetweenJobs(unit.state));
    // What becomes of a part under way when the PLC falls silent is 2101's, by `modbus.watchdog_action`.
    if (is_heard && suspends(guard.code) && counts) present.push_back({guard.code, guard.sentence});
  }
  if (!is_heard && !restsBetweenJobs(unit.state))
    for (const int id : raised_)
      if (isSuspension(id)) present.push_back({id, ""});
  // What was pressed stays pressed while nobody says otherwise.
  if (found.is_emergency_stop_pressed && (comes(found) || raised_.count(kEmergencyStopReported) != 0))
    present.push_back({kEmergencyStopReported, "the PLC reports the emergency stop pressed"});
  if (const auto silent = silence(unit, now_s)) present.push_back({kPlcSilent, *silent});
  return present;
}

std::optional<std::string> PlcWatch::silence(const UnitStatus& unit, double now_s) {
  const bool is_link_heard = report_ && now_s - heard_s_ <= kLongestLinkSilence;
  const PlcHeartbeat heartbeat = report_ ? report_->heartbeat : PlcHeartbeat::Unarmed;
  const bool is_lost = isLost(heartbeat);
  if (is_link_heard && is_lost && report_->on_silence != WatchdogAction::None)
    return "the PLC's heartbeat does not come";
  const bool is_ignored = !settings_.is_required && report_ && report_->on_silence == WatchdogAction::None;
  const bool is_expected = (settings_.is_required || is_armed_) && !is_ignored;
  const bool is_missing = is_expected && (!restsBetweenJobs(unit.state) || raised_.count(kPlcSilent) != 0) &&
                          (!is_link_heard || heartbeat == PlcHeartbeat::Unarmed);
  if (!is_missing) {
    missing_since_s_.reset();
    // A link that dies says nothing new: the alarm that it has raised stays.
    if (!is_link_heard && is_lost && raised_.count(kPlcSilent) != 0) return "the PLC's link is silent";
    return std::nullopt;
  }
  if (!missing_since_s_) missing_since_s_ = now_s;
  if (raised_.count(kPlcSilent) == 0 && now_s - *missing_since_s_ <= settings_.patience_s)
    return std::nullopt;
  const std::string why = settings_.is_required ? "which is required" : "which was heard before";
  return is_link_heard ? "the PLC, " + why + ", has not called"
                       : "the link to the PLC, " + why + ", is silent";
}

std::optional<UnitCommand> PlcWatch::ordered(const UnitStatus& unit) {
  if (std::exchange(is_stop_due_, false) && !restsBetweenJobs(unit.state)) return UnitCommand::Stop;
  // A unit that runs when this is heard first is held before it is stopped.
  if (is_abandoned_ && (isWaiting(unit.state) || restsBetweenJobs(unit.state))) {
    is_abandoned_ = false;
    if (isWaiting(unit.state)) return UnitCommand::Stop;
  }
  const bool is_ours =
      unit.state == UnitState::Suspended && unit.stop_reason && isSuspension(unit.stop_reason->id);
  if (!settings_.unsuspends || !is_ours || unsuspended_ == unit.sequence) return std::nullopt;
  if (!raised_.empty() || !unit.alarms.from(AlarmCategory::Suspend).empty()) return std::nullopt;
  unsuspended_ = unit.sequence;
  return UnitCommand::Unsuspend;
}

}  // namespace lamina
