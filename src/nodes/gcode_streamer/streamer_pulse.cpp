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

/// A dryer that the operator switched on is not this node's.
bool isAtWork(const StartupStatus& status, const StartupSettings& settings) {
  if (status.step == StartupStep::DryPellets && settings.dry_code.empty()) return false;
  return status.state == StartupState::Running;
}

/// What a start-up has heated stays hot between jobs, also after its step was lost.
bool isAtWork(const StartupReport& startup, const StartupSettings& settings) {
  return startup.may_be_on ||
         std::any_of(startup.steps.begin(), startup.steps.end(),
                     [&](const StartupStatus& status) { return isAtWork(status, settings); });
}

}  // namespace

MachinePulse pulseOf(const GcodeStreamerSettings& settings, PackmlState job, const StreamStatus& status,
                     const StartupReport& startup) {
  MachinePulse pulse;
  const bool is_streaming = isAtWork(job);
  const bool is_started_up = isAtWork(startup, settings.startup);
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
