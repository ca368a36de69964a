// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Who stops a machine whose streamer is gone, and when.
#include "nodes/host_watch/watch_settings.hpp"
#include "ros/settings/node_probes.hpp"

namespace lamina::test {
namespace {

MachinePulse workingPulse() { return {true, {"/dev/ttyUSB0", 115200}, "marlin", "/a.gcode", false, true}; }

/// Times at which something happens by itself, until the machine is stopped.
std::string untilStopped(MachineGuard& guard) {
  std::vector<double> times;
  for (int i = 0; i < 5; ++i) {
    const double at = guard.nextDeadline();
    if (!std::isfinite(at)) break;
    times.push_back(at);
    if (guard.due(at)) break;
  }
  return numbersText(times);
}

/// When a machine is stopped whose streamer hangs at 1 s.
std::string hung(const SettingTexts& set) {
  MachineGuard guard(settingsWith<HostWatchNodeSettings>(set).guard);
  guard.hear(workingPulse(), 100, 1.0);
  return untilStopped(guard);
}

/// When a machine is stopped whose streamer came back a second after its end, and does nothing.
std::string cameBack(const SettingTexts& set) {
  MachineGuard guard(settingsWith<HostWatchNodeSettings>(set).guard);
  guard.hear(workingPulse(), 100, 0.0);
  guard.end(100, 1.0);
  const MachinePulse at_rest{false, {"/dev/ttyUSB0", 115200}, "marlin", "", false};
  std::string text;
  for (double now_s = 2.0; now_s < 1000.0; now_s += 0.1) {
    guard.hear(at_rest, 101, now_s);
    if (guard.due(now_s)) return numbersText({now_s});
  }
  return "not at all";
}

}  // namespace

std::vector<SettingProbe> guardProbes() {
  return {{"a streamer that hangs", "", hung, {{"guard.silence_s=2"}, {"guard.grace_s=20"}}},
          {"a streamer that came back and does nothing", "", cameBack, {{"guard.unattended_s=60"}}}};
}

}  // namespace lamina::test
