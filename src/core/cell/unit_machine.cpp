// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/unit_machine.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr int kHeldByOperator = 1001;
constexpr int kAbortedByOperator = 1002;
constexpr int kStateTooLong = 1010;

bool isStopping(UnitCommand command) {
  return command == UnitCommand::Stop || command == UnitCommand::Hold || command == UnitCommand::Abort;
}

/// On its way to depositing, or at it: an alarm that stops has something to stop.
bool isRunning(UnitState state) {
  switch (state) {
    case UnitState::Starting:
    case UnitState::Execute:
    case UnitState::Unholding:
    case UnitState::Suspending:
    case UnitState::Unsuspending:
      return true;
    default:
      return false;
  }
}

bool isSuspended(UnitState state) { return state == UnitState::Suspending || state == UnitState::Suspended; }

/// The mildest category whose alarms stand against a command; nothing if none do.
std::optional<AlarmCategory> refusedFrom(UnitCommand command) {
  switch (command) {
    case UnitCommand::Start:
    case UnitCommand::Unhold:
    case UnitCommand::Unsuspend:
      return AlarmCategory::Suspend;
    case UnitCommand::Reset:
    case UnitCommand::Clear:
      return AlarmCategory::Hold;
    default:
      return std::nullopt;
  }
}

std::string describe(const ActiveAlarm& alarm) {
  std::string sentence = "alarm " + std::to_string(alarm.id) + " (" + alarmKind(alarm.id).title + ")";
  sentence += alarm.gone_s ? " is not acknowledged" : " is still there";
  return alarm.message.empty() ? sentence : sentence + ": " + alarm.message;
}

/// An alarm that has just been raised.
ActiveAlarm activeOf(const ActiveAlarms& alarms, int id) {
  return *std::find_if(alarms.all().begin(), alarms.all().end(),
                       [id](const ActiveAlarm& alarm) { return alarm.id == id; });
}

std::string acceptedNames(UnitState state, HoldRule rule) {
  std::vector<std::string> names;
  for (const UnitCommand command : acceptedIn(state, rule)) names.emplace_back(toString(command));
  return listed(names);
}

std::string namesOf(const std::vector<UnitMode>& modes) {
  std::vector<std::string> names;
  names.reserve(modes.size());
  for (const UnitMode& mode : modes) names.push_back(std::to_string(mode.number) + " (" + mode.name + ")");
  return listed(names);
}

}  // namespace

UnitMachine::UnitMachine(UnitSettings settings, UnitState first, UnitCounters counters, double now_s)
    : settings_(std::move(settings)), counted_until_s_(now_s) {
  status_.state = first;
  status_.state_since_s = now_s;
  status_.mode_since_s = now_s;
  status_.counters = std::move(counters);
}

const UnitMode& UnitMachine::mode() const {
  const auto found = std::find_if(settings_.modes.begin(), settings_.modes.end(),
                                  [this](const UnitMode& mode) { return mode.number == status_.mode; });
  if (found == settings_.modes.end())
    throw InvalidConfig("mode " + std::to_string(status_.mode) + " of the unit is not among its modes");
  return *found;
}

CommandAnswer UnitMachine::command(const UnitRequest& request, double now_s) {
  const std::string asked =
      std::string(toString(request.command)) + " in " + toString(status_.state) + " (" + mode().name + ")";
  const auto next = commanded(status_.state, request.command, settings_.hold_rule);
  if (!next)
    return {CommandResult::NotInThisState,
            asked + " is not accepted; accepted now: " + acceptedNames(status_.state, settings_.hold_rule)};
  if (const auto refused = refusal(request, *next)) return {refused->result, asked + ": " + refused->reason};
  enter(*next, {0.0, 0, 0, {}, {}, request.command, request.source, "", 0}, now_s);
  if (request.command == UnitCommand::Hold) note(kHeldByOperator, request.source, now_s);
  if (request.command == UnitCommand::Abort) note(kAbortedByOperator, request.source, now_s);
  return {};
}

std::vector<CommandAnswer> UnitMachine::step(const std::vector<UnitRequest>& requests,
                                             std::optional<UnitState> done, double now_s) {
  std::vector<CommandAnswer> answers(requests.size());
  const auto answer = [&](int rank) {
    for (std::size_t i = 0; i < requests.size(); ++i)
      if (precedence(requests[i].command) == rank) answers[i] = command(requests[i], now_s);
  };
  for (int rank = 0; rank < kLastPrecedence; ++rank) answer(rank);
  if (done) complete(*done, now_s);
  answer(kLastPrecedence);
  return answers;
}

std::optional<CommandAnswer> UnitMachine::refusal(const UnitRequest& request, UnitState next) const {
  if (!hasState(mode(), next))
    return CommandAnswer{CommandResult::NotInThisMode, std::string("the mode has no ") + toString(next)};
  if (isStopping(request.command)) return std::nullopt;
  if (request.expected_sequence && *request.expected_sequence != status_.sequence)
    return CommandAnswer{CommandResult::StaleSequence,
                         "meant for state change " + std::to_string(*request.expected_sequence) +
                             ", but the unit is at " + std::to_string(status_.sequence)};
  std::vector<std::string> against;
  if (const auto category = refusedFrom(request.command))
    for (const ActiveAlarm& alarm : status_.alarms.from(*category)) against.push_back(describe(alarm));
  for (const UnmetGuard& guard : request.unmet) against.push_back(guard.sentence);
  if (against.empty()) return std::nullopt;
  return CommandAnswer{CommandResult::GuardFailed, listed(against, "; ")};
}

CommandAnswer UnitMachine::changeMode(int mode, const std::string& source, double now_s) {
  const std::string asked = "mode " + std::to_string(mode);
  const auto found = std::find_if(settings_.modes.begin(), settings_.modes.end(),
                                  [mode](const UnitMode& known) { return known.number == mode; });
  if (found == settings_.modes.end())
    return {CommandResult::BadValue, asked + " is not known; expected one of " + namesOf(settings_.modes)};
  if (!canChangeMode(status_.state))
    return {CommandResult::NotInThisState,
            asked + " is not taken up in " + toString(status_.state) + "; expected Idle, Stopped or Aborted"};
  if (!hasState(*found, status_.state))
    return {CommandResult::NotInThisMode, asked + " has no " + toString(status_.state)};
  if (mode == status_.mode) return {};
  count(now_s);
  status_.mode = mode;
  status_.mode_since_s = now_s;
  changes_.push_back({now_s, status_.sequence, mode, status_.state, status_.state, {}, source, "", 0});
  return {};
}

void UnitMachine::complete(UnitState state, double now_s) {
  auto next = completed(state);
  if (state != status_.state || !next) return;
  const auto gravest = status_.alarms.gravest();
  if (state == UnitState::Clearing && gravest && *gravest == AlarmCategory::Abort) return;
  if (!hasState(mode(), *next)) next = UnitState::Stopping;
  enter(*next, {0.0, 0, 0, {}, {}, {}, "unit", "", 0}, now_s);
}

bool UnitMachine::raise(int alarm, double value, const std::string& message, double now_s) {
  const ActiveAlarms::Raised raised = status_.alarms.raise(alarm, value, message, now_s);
  react(activeOf(status_.alarms, alarm), now_s);
  return raised != ActiveAlarms::Raised::Flooding;
}

void UnitMachine::restore(int alarm, double value, const std::string& message, double raised_s,
                          double now_s) {
  status_.alarms.raise(alarm, value, message, raised_s);
  const ActiveAlarm active = activeOf(status_.alarms, alarm);
  status_.alarms.end(alarm, now_s);
  const bool is_stopped = status_.state != UnitState::Execute && status_.state != UnitState::Idle;
  if (is_stopped && !status_.stop_reason) status_.stop_reason = active;
}

void UnitMachine::reactTo(int alarm, double now_s) { react(activeOf(status_.alarms, alarm), now_s); }

CommandAnswer UnitMachine::acknowledge(int alarm, const std::string& by, double now_s) {
  if (status_.alarms.acknowledge(alarm, by, now_s)) return {};
  return {CommandResult::BadValue, "alarm " + std::to_string(alarm) + " is not active"};
}

void UnitMachine::tick(double now_s) {
  count(now_s);
  const double longest_s = settings_.longest_s.at(static_cast<std::size_t>(status_.state) - 1);
  const double lasted_s = now_s - status_.state_since_s;
  if (longest_s <= 0.0 || lasted_s <= longest_s || !isActing(status_.state)) return;
  const std::string reason = std::string(toString(status_.state)) + " has lasted " +
                             std::to_string(std::lround(lasted_s)) + " s; expected at most " +
                             std::to_string(std::lround(longest_s)) + " s";
  if (status_.state == UnitState::Aborting) {
    raiseOwn(kStateTooLong, lasted_s, reason + ": nobody confirms that the unit is at rest", now_s);
    enter(UnitState::Aborted, {0.0, 0, 0, {}, {}, {}, "unit", reason, 0}, now_s);
    return;
  }
  react(raiseOwn(kStateTooLong, lasted_s, reason, now_s), now_s);
}

void UnitMachine::countPart(PartVerdict verdict, double material_mm3) {
  ++status_.counters.parts;
  if (verdict == PartVerdict::Defective) ++status_.counters.defective;
  status_.counters.material_mm3 += material_mm3;
}

std::vector<UnitChange> UnitMachine::takeChanges() { return std::exchange(changes_, {}); }

std::vector<ActiveAlarm> UnitMachine::takeAlarms() { return std::exchange(own_alarms_, {}); }

void UnitMachine::enter(UnitState state, UnitChange change, double now_s) {
  count(now_s);
  change.time_s = now_s;
  change.mode = status_.mode;
  change.from = status_.state;
  change.to = state;
  change.sequence = ++status_.sequence;
  status_.state = state;
  status_.state_since_s = now_s;
  if (state == UnitState::Execute || state == UnitState::Idle) status_.stop_reason.reset();
  if (state == UnitState::Resetting) status_.alarms.forgetEvents();
  changes_.push_back(std::move(change));
}

bool UnitMachine::follow(UnitCommand command, const ActiveAlarm& alarm, double now_s) {
  const auto next = commanded(status_.state, command, settings_.hold_rule);
  if (!next || !hasState(mode(), *next)) return false;
  enter(*next, {0.0, 0, 0, {}, {}, command, "alarm", sentenceOf(alarm), alarm.id}, now_s);
  return true;
}

void UnitMachine::react(const ActiveAlarm& alarm, double now_s) {
  const UnitState before = status_.state;
  switch (alarm.category) {
    case AlarmCategory::Information:
    case AlarmCategory::Warning:
      return;
    case AlarmCategory::Suspend:
      if (isSuspended(status_.state) || follow(UnitCommand::Suspend, alarm, now_s)) break;
      [[fallthrough]];
    case AlarmCategory::Hold:
      if (follow(UnitCommand::Hold, alarm, now_s)) break;
      if (!isRunning(status_.state)) break;
      [[fallthrough]];
    case AlarmCategory::Stop:
      follow(UnitCommand::Stop, alarm, now_s);
      break;
    case AlarmCategory::Abort:
      follow(UnitCommand::Abort, alarm, now_s);
      break;
  }
  if (status_.state != before && !status_.stop_reason) status_.stop_reason = alarm;
}

void UnitMachine::note(int alarm, const std::string& source, double now_s) {
  const ActiveAlarm raised = raiseOwn(alarm, 0.0, source.empty() ? "" : "by " + source, now_s);
  if (!status_.stop_reason) status_.stop_reason = raised;
}

ActiveAlarm UnitMachine::raiseOwn(int alarm, double value, const std::string& message, double now_s) {
  const ActiveAlarms::Raised raised = status_.alarms.raise(alarm, value, message, now_s);
  ActiveAlarm active = activeOf(status_.alarms, alarm);
  if (raised != ActiveAlarms::Raised::Flooding) own_alarms_.push_back(active);
  return active;
}

void UnitMachine::count(double now_s) {
  const double duration_s = std::max(0.0, now_s - counted_until_s_);
  if (duration_s > 0.0)
    status_.counters = counted(std::move(status_.counters), status_.mode, status_.state, duration_s);
  counted_until_s_ = std::max(counted_until_s_, now_s);
}

}  // namespace lamina
