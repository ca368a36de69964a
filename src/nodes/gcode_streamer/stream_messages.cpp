// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream_messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "conversions.hpp"
#include "status.hpp"

namespace lamina {
namespace {

constexpr char kNotReported[] = "not reported by this firmware";

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Messages count in 32 bits: a count that has more stays at the largest.
std::uint32_t count(std::uint64_t value) {
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(value, std::numeric_limits<std::uint32_t>::max()));
}

/// Without the last bits, which are of the fraction: 1.1 is 110 %, where a whole number may be asked for.
double inUnit(double value, double per_unit) {
  constexpr double kSteps = 1e6;
  return std::round(kSteps * per_unit * value) / kSteps;
}

const char* counterOf(StarvationSource source) {
  if (source == StarvationSource::Nobody) return "nobody";
  return source == StarvationSource::Machine ? "machine" : "streamer";
}

void addStarvation(const Starvation& starvation, diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  if (starvation.source == StarvationSource::Nobody) {
    diagnostics.add("times starved", kNotReported);
  } else {
    diagnostics.add("times starved", starvation.count);
  }
  if (starvation.source == StarvationSource::Streamer) {
    diagnostics.add("longest starvation [s]", starvation.longest_s);
  } else {
    diagnostics.add("longest starvation [s]", kNotReported);
  }
}

}  // namespace

LiveChange liveChangeOf(const std::string& setting, double value) {
  constexpr double kPercent = 100.0;
  constexpr double kMillimetres = 1000.0;
  if (setting == "feed" || setting == "flow" || setting == "rapid" || setting == "spindle" ||
      setting == "power")
    return liveChange(setting, inUnit(value, kPercent));
  if (setting == "babystep") return liveChange(setting, inUnit(value, kMillimetres));
  return liveChange(setting, value);
}

lamina_msgs::MachineState toMachineState(const StreamStatus& status, const std::string& job) {
  lamina_msgs::MachineState message;
  message.state = static_cast<std::uint8_t>(status.state);
  message.state_name = toString(status.state);
  message.job = job;
  message.lines_total = count(status.lines_total);
  message.lines_sent = count(status.lines_sent);
  message.lines_acknowledged = count(status.lines_acknowledged);
  message.resends = count(status.resends);
  message.layer = status.layer;
  message.position.x = message.position.y = message.position.z = kUnknown;
  message.nozzle_temperature = message.bed_temperature = kUnknown;
  if (status.position) {
    message.position = toMessage(Point3(status.position->x, status.position->y, status.position->z));
  }
  if (status.temperatures) {
    message.nozzle_temperature = status.temperatures->nozzle_c;
    message.bed_temperature = status.temperatures->bed_c.value_or(kUnknown);
  }
  message.status = toMessage(status.failure);
  if (message.status.message.empty()) message.status.message = status.wait;
  return message;
}

lamina_msgs::HeaterState toHeaterState(const StreamStatus& status) {
  lamina_msgs::HeaterState message;
  message.nozzle = message.nozzle_target = message.bed = message.bed_target = kUnknown;
  if (!status.temperatures) return message;
  message.nozzle = status.temperatures->nozzle_c;
  message.nozzle_target = status.temperatures->nozzle_target_c.value_or(kUnknown);
  message.bed = status.temperatures->bed_c.value_or(kUnknown);
  message.bed_target = status.temperatures->bed_target_c.value_or(kUnknown);
  return message;
}

lamina_msgs::PrintProgress toPrintProgress(const StreamStatus& status, const LaidFilament& laid,
                                           const std::string& job) {
  lamina_msgs::PrintProgress message;
  message.job = job;
  message.laid_length = toMetres(laid.length());
  message.laid_volume = 1e-9 * laid.volume();
  message.tip_speed = status.state == PackmlState::Execute ? toMetres(laid.feed()) : 0.0;
  return message;
}

lamina_msgs::StreamProgramFeedback toFeedback(const StreamStatus& status) {
  lamina_msgs::StreamProgramFeedback feedback;
  feedback.state = toString(status.state);
  feedback.lines_total = count(status.lines_total);
  feedback.lines_acknowledged = count(status.lines_acknowledged);
  feedback.layer = status.layer;
  if (status.lines_total > 0) {
    feedback.fraction =
        static_cast<float>(status.lines_acknowledged) / static_cast<float>(status.lines_total);
  }
  return feedback;
}

lamina_msgs::StreamProgramResult toResult(const StreamStatus& status, double duration_s) {
  lamina_msgs::StreamProgramResult result;
  result.status = toMessage(status.failure);
  result.lines_acknowledged = count(status.lines_acknowledged);
  result.resends = count(status.resends);
  result.duration = duration_s;
  result.firmware = status.firmware_name;
  result.commands_not_done = count(status.commands_not_done);
  result.first_not_done = status.first_not_done;
  const Starvation& starvation = status.starvation;
  result.starvations = count(starvation.count);
  result.starvations_counted_by = counterOf(starvation.source);
  result.longest_starvation = starvation.source == StarvationSource::Streamer
                                  ? starvation.longest_s
                                  : std::numeric_limits<double>::quiet_NaN();
  result.longest_starvation_line = count(starvation.line);
  return result;
}

void fillDiagnostics(const StreamStatus& status, diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  using diagnostic_msgs::DiagnosticStatus;
  if (status.failure.code == ErrorCode::Cancelled || status.failure.code == ErrorCode::Ok) {
    const bool is_troubled = status.resends > 0 || status.commands_not_done > 0 ||
                             status.starvation.count > 0 || !status.message.empty() ||
                             !status.warning.empty();
    diagnostics.summary(is_troubled ? DiagnosticStatus::WARN : DiagnosticStatus::OK, toString(status.state));
  } else {
    diagnostics.summary(DiagnosticStatus::ERROR, status.failure.message);
  }
  diagnostics.add("state", toString(status.state));
  diagnostics.add("lines acknowledged", status.lines_acknowledged);
  diagnostics.add("lines in all", status.lines_total);
  diagnostics.add("resends", status.resends);
  diagnostics.add("probes", status.probes);
  diagnostics.add("firmware", status.firmware_name);
  diagnostics.add("commands not done", status.commands_not_done);
  addStarvation(status.starvation, diagnostics);
  diagnostics.add("last message", status.message);
  diagnostics.add("warning", status.warning);
  if (!status.temperatures) return;
  diagnostics.add("nozzle [degC]", status.temperatures->nozzle_c);
  if (status.temperatures->nozzle_target_c) {
    diagnostics.add("nozzle target [degC]", *status.temperatures->nozzle_target_c);
  }
  if (status.temperatures->bed_c) diagnostics.add("bed [degC]", *status.temperatures->bed_c);
  if (status.temperatures->bed_target_c) {
    diagnostics.add("bed target [degC]", *status.temperatures->bed_target_c);
  }
}

}  // namespace lamina
