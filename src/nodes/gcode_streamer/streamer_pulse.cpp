// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streamer_pulse.hpp"

#include <algorithm>

namespace lamina {
namespace {

/// A machine to which nothing was sent yet may be at work for somebody else.
bool isAtWork(PackmlState state) {
  return state != PackmlState::Idle && state != PackmlState::Starting && !isFinal(state);
}

/// What a start-up has heated stays hot between jobs. A dryer that the operator switched on is not this
/// node's.
bool isAtWork(const lamina_msgs::StartupStep& step, const StartupSettings& settings) {
  using Step = lamina_msgs::StartupStep;
  if (step.name == "dry_pellets" && settings.dry_code.empty()) return false;
  return step.state == Step::RUNNING || (step.state == Step::DONE && step.name == "heat_bed");
}

}  // namespace

MachinePulse pulseOf(const GcodeStreamerSettings& settings, PackmlState job, const StreamStatus& status,
                     const std::vector<lamina_msgs::StartupStep>& steps) {
  MachinePulse pulse;
  const bool is_streaming = isAtWork(job);
  const bool is_started_up = std::any_of(steps.begin(), steps.end(),
                                         [&](const auto& step) { return isAtWork(step, settings.startup); });
  // A print server prints on by itself.
  pulse.is_at_work = (is_streaming || is_started_up) && settings.port.name.rfind("http", 0) != 0;
  pulse.has_job = is_streaming;
  pulse.port = settings.port;
  pulse.firmware = settings.stream.firmware;
  const bool is_known = is_streaming || !status.firmware_name.empty();
  if (pulse.firmware == kAnyFirmware && is_known) pulse.firmware = protocolOfFirmware(status.firmware_name);
  pulse.keeps_heaters_on = settings.stream.keep_heaters_on;
  return pulse;
}

}  // namespace lamina
