// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_messages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "conversions.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr int kResumeUnconfirmed = 1315;

std::string sentencesOf(const std::vector<UnmetGuard>& against) {
  std::vector<std::string> sentences;
  sentences.reserve(against.size());
  for (const UnmetGuard& guard : against) sentences.push_back(guard.sentence);
  return listed(sentences, "; ");
}

}  // namespace

double fractionOf(const ExecutorReport& report) {
  if (report.lines == 0) return 0.0;
  return static_cast<double>(report.progress.taken_through) / static_cast<double>(report.lines);
}

lamina_msgs::CellAlarm toMessage(const ActiveAlarm& alarm) {
  const AlarmKind& kind = alarmKind(alarm.id);
  lamina_msgs::CellAlarm message;
  message.id = alarm.id;
  message.category = std::string(1, letterOf(alarm.category));
  message.title = kind.title;
  message.remedy = kind.remedy;
  message.value = alarm.value;
  message.message = alarm.message;
  message.is_gone = alarm.gone_s.has_value();
  message.is_acknowledged = alarm.acknowledged_s.has_value();
  message.acknowledged_by = alarm.acknowledged_by;
  message.times = static_cast<std::uint32_t>(alarm.times);
  return message;
}

lamina_msgs::ResumeStep toMessage(const ResumeStep& step) {
  lamina_msgs::ResumeStep message;
  message.name = step.name;
  message.state = static_cast<std::uint8_t>(step.state);
  message.text = step.text;
  message.begin_length = step.begin_mm ? toMetres(*step.begin_mm) : std::numeric_limits<double>::quiet_NaN();
  return message;
}

std::string faultOf(const lamina_msgs::PackmlCommand::Request& request) {
  using Request = lamina_msgs::PackmlCommand::Request;
  if (!unitCommand(request.command) || request.cut_off > Request::DISCARD)
    return "command " + std::to_string(request.command) + " with cut_off " + std::to_string(request.cut_off) +
           " is not known; expected 1 to 10, and 0 to 2";
  if (request.confirmed_length.size() <= 1) return {};
  return "confirmed_length has " + std::to_string(request.confirmed_length.size()) +
         " numbers; expected one at most";
}

ResumeConfirmation confirmationOf(const lamina_msgs::PackmlCommand::Request& request) {
  ResumeConfirmation confirmed;
  confirmed.steps = request.confirmed;
  if (!request.confirmed_length.empty()) confirmed.begin_mm = toMillimetres(request.confirmed_length.front());
  return confirmed;
}

std::vector<UnmetGuard> againstUnconfirmed(const std::vector<ResumeStep>& steps,
                                           const ResumeConfirmation& confirmed) {
  std::vector<UnmetGuard> against;
  for (std::string& sentence : unconfirmed(steps, confirmed))
    against.push_back({kResumeUnconfirmed, std::move(sentence)});
  return against;
}

std::optional<CommandAnswer> expiredAnswer(const lamina_msgs::PackmlCommand::Request& request,
                                           UnitCommand command) {
  if (request.expires.isZero() || precedence(command) <= precedence(UnitCommand::Hold)) return std::nullopt;
  const double late_s = ros::WallTime::now().toSec() - request.expires.toSec();
  if (late_s <= 0.0) return std::nullopt;
  return CommandAnswer{CommandResult::StaleSequence,
                       std::string(toString(command)) + " came " + numberText(late_s) +
                           " s after it had expired; expected it in time, or clocks that agree"};
}

std::string lineText(std::uint64_t taken_through) {
  return "the machine took line " + std::to_string(taken_through) +
         " for certain; it is asked which one it took last, and the next one is sent: each is run once";
}

std::string temperaturesText(const lamina_msgs::MachineState& machine) {
  std::string text;
  const auto add = [&text](const std::string& what, double value) {
    if (std::isfinite(value))
      text += (text.empty() ? "" : ", ") + what + (' ' + numberText(std::round(value))) + " °C";
  };
  add("nozzle", machine.nozzle_temperature);
  add("bed", machine.bed_temperature);
  return text;
}

lamina_msgs::CellJob toMessage(const QueuedJob& job) {
  lamina_msgs::CellJob message;
  message.id = static_cast<std::uint32_t>(job.id);
  message.name = job.name;
  message.part = job.part;
  message.machine = job.machine;
  message.digest = job.digest;
  message.state = static_cast<std::uint8_t>(job.state);
  message.state_name = toString(job.state);
  message.created_by = job.created_by;
  message.released_by = job.released_by;
  return message;
}

lamina_msgs::PackmlStatus toMessage(const ProductionCell& cell, const std::vector<UnitMode>& modes,
                                    HoldRule rule, double now_s) {
  const UnitStatus& unit = cell.status();
  lamina_msgs::PackmlStatus message;
  message.state = static_cast<std::uint8_t>(unit.state);
  message.state_name = toString(unit.state);
  message.sequence = unit.sequence;
  message.in_state = now_s - unit.state_since_s;
  message.mode = static_cast<std::uint8_t>(unit.mode);
  const auto mode = std::find_if(modes.begin(), modes.end(),
                                 [&unit](const UnitMode& known) { return known.number == unit.mode; });
  if (mode != modes.end()) message.mode_name = mode->name;
  message.in_mode = now_s - unit.mode_since_s;
  for (const UnitCommand command : acceptedIn(unit.state, rule))
    message.accepted_now.push_back(static_cast<std::uint8_t>(command));
  if (unit.stop_reason) {
    message.stop_reason = unit.stop_reason->id;
    message.stop_value = unit.stop_reason->value;
    message.stop_message = unit.stop_reason->message;
  }
  if (const auto job = cell.currentJob()) {
    message.job = toMessage(*job);
    message.layers = job->layers;
  }
  message.resume_waits = cell.resumeWaits();
  message.resume_refusal = sentencesOf(cell.againstResuming());
  message.is_part_on_plate = cell.isPartOnPlate();
  const ExecutorReport& report = cell.report();
  message.lines = static_cast<std::uint32_t>(report.lines);
  message.lines_acknowledged = static_cast<std::uint32_t>(report.progress.taken_through);
  message.layer = report.progress.layer;
  message.fraction = fractionOf(report);
  message.laid_length = 1e-3 * report.progress.path_mm;
  message.material = 1e-9 * report.progress.deposited_mm3;
  message.parts = static_cast<std::uint32_t>(unit.counters.parts);
  message.defective = static_cast<std::uint32_t>(unit.counters.defective);
  message.running = timeIn(unit.counters, kProduction, UnitState::Execute);
  return message;
}

}  // namespace lamina
