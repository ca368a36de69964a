// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The emulated machine, asked at times that are set.
#include "job/settings/setting_probe.hpp"
#include "job/settings/streaming/session_text.hpp"
#include "lamina/streaming/emulator/emulated_firmware.hpp"

namespace lamina::test {
namespace {

struct SaidAt {
  double wall_s = 0.0;
  std::string text;
};
using Script = std::vector<SaidAt>;

/// What the machine answers when, and the motions it runs when, of what it is told when.
std::function<std::string(const SettingTexts& set)> asked(const Script& script,
                                                          const std::vector<Fault>& faults = {}) {
  return [script, faults](const SettingTexts& set) {
    std::string text;
    EmulatedObserver observer;
    observer.line = [&](const ExecutedLine& line) { text += "ran " + line.command + "\n"; };
    observer.motion = [&](const ExecutedMotion& motion) {
      text += numbersText({motion.start_s, motion.end_s, motion.end.x(), motion.end.z()});
    };
    EmulatedFirmware firmware(settingsWith<EmulatedSettings>(set), faults, observer);
    const auto note = [&](double wall_s) {
      const std::string said = firmware.takeOutput();
      if (!said.empty()) text += std::to_string(wall_s) + " " + said;
    };
    firmware.elapse(0.0);
    for (const SaidAt& next : script) {
      for (double wall_s = firmware.nextDeadline(); wall_s <= next.wall_s; wall_s = firmware.nextDeadline()) {
        firmware.elapse(wall_s);
        note(wall_s);
      }
      firmware.elapse(next.wall_s);
      firmware.receive(next.text, next.wall_s);
      note(next.wall_s);
    }
    return text + numbersText({double(firmware.counts().bytes_lost), double(firmware.counts().faults)});
  };
}

std::string movesBy(int count, double step_mm) {
  std::string text;
  for (int i = 1; i <= count; ++i) text += "G1 X" + std::to_string(step_mm * i) + " F600\n";
  return text;
}

SettingProbe heatingProbe() {
  return {"heating",
          "",
          asked({{0, "M104 S100\nM140 S60\n"}, {5, "M105\n"}, {60, "M105\n"}}),
          {{"emulator.ambient_c=15"},
           {"emulator.nozzle_heating_c_s=2"},
           {"emulator.bed_heating_c_s=1"},
           {"emulator.bed_limit_c=40"}}};
}

SettingProbe queuesProbe() {
  return {"queues",
          "emulator.block_queue=8",
          asked({{0, movesBy(16, 1)}, {0.01, movesBy(4, 30)}, {60, "M400\n"}, {200, "M105\n"}}),
          {{"emulator.speed_up=2"},
           {"emulator.block_queue=4"},
           {"emulator.command_queue=2"},
           {"emulator.rx_buffer_bytes=256"},

           {"emulator.moves_unhomed=false"}}};
}

SettingProbe longLineProbe() {
  return {"a long line",
          "",
          asked({{0, "M117 0123456789012345678901234567890123456789\n"}, {1, "M105\n"}}),
          {{"emulator.max_line_bytes=32"}}};
}

SettingProbe waitingProbe() {
  return {"waiting",
          "",
          asked({{0, "M109 S200\n"}, {5, "M108\n"}, {8, "M105\n"}, {100, "M105\n"}}),
          {{"emulator.emergency_parser=false"}, {"emulator.busy_interval_s=1"}}};
}

SettingProbe peripheryProbe() {
  return {"periphery",
          "emulator.has_dryer=true;emulator.vacuum_zones=2;emulator.leaking_zone=2;emulator.speed_up=1",
          asked({{0, "M141 S80\n"},
                 {0.1, "M42 P1 S255\nM42 P2 S255\n"},
                 {3, "M43 P1\nM43 P2\nM105\n"},
                 {40, "M43 P1\nM43 P2\nM43 P3\n"},
                 {41, "G28\n"},
                 {100, "G29\n"},
                 {300, "M105\n"}}),
          {{"emulator.has_dryer=false"},
           {"emulator.dryer_heating_c_s=1"},
           {"emulator.vacuum_zones=3"},
           {"emulator.vacuum_time_s=2"},
           {"emulator.vacuum_kpa=20"},
           {"emulator.leaking_zone=1"},
           {"emulator.leak_kpa=50"},
           {"emulator.bump_mm=0.5"}}};
}

SettingProbe faultsProbe() {
  const std::vector<Fault> faults = {
      {FaultKind::DelayedOk, 0.0, {1}}, {FaultKind::Silence, 0.0, {2}}, {FaultKind::CorruptedLine, 0.0, {3}}};
  return {"faults",
          "",
          asked({{0, "N1 M105*38\n"},
                 {3, "N2 M105*37\n"},
                 {6, "N3 M117 a long enough line*62\n"},
                 {9, "M105\n"},
                 {12, "M105\n"}},
                faults),
          {{"emulator.fault_delay_s=1"}, {"emulator.fault_silence_s=2"}, {"emulator.fault_seed=7"}}};
}

}  // namespace

std::vector<SettingProbe> emulatorProbes() {
  return {heatingProbe(),
          queuesProbe(),
          longLineProbe(),
          waitingProbe(),
          peripheryProbe(),
          faultsProbe(),
          {"a machine that is unplugged",
           "emulator.fault_replug_s=0.05",
           unplugged,
           {{"emulator.fault_replug_s=2"}}}};
}

}  // namespace lamina::test
