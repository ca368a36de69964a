// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The start-up of the large gantry, with a machine played by hand.
#include "job/settings/setting_probe.hpp"
#include "job/settings/streaming/session_text.hpp"
#include "startup/started_machine.hpp"

namespace lamina::test {
namespace {

StartupSettings gantryWith(const SettingTexts& set) {
  StartupSettings settings = largeGantry();
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& setting : set) schema.set(setting.key, setting.text);
  return settings;
}

std::string statesOf(const StartedMachine& machine) {
  std::string text;
  for (const StartupStatus& status : machine.startup.steps())
    text += std::string(toString(status.step)) + " " + toString(status.state) + ": " + status.reason + " " +
            status.expected + "\n";
  return text;
}

/// Begins a step, whoever does it.
void enter(StartedMachine& machine, StartupStep step) {
  if (step == StartupStep::TransferProgram)
    return machine.startup.onTransferred(machine.program, machine.now_s);
  try {
    machine.startup.confirm(step, machine.now_s);
  } catch (const Rejected&) {
    machine.startup.begin(step, machine.now_s);
  }
}

/// Brings a step as far as a machine in order would, and what was sent for it.
std::string codesOf(StartedMachine& machine, StartupStep step) {
  std::string codes;
  for (int i = 0; i < 5; ++i) {
    const auto code = machine.startup.nextCode(step);
    if (!code) break;
    codes += *code;
    if (step == StartupStep::HeatBed) machine.sayBed(i == 0 ? 20.0 : 89.5);
    if (step == StartupStep::DrawVacuum) machine.sayZones(30.0);
    if (const auto axis = homedAxis(step)) machine.say("homed: " + machine.homedAxes() + *axis);
    if (step == StartupStep::MapHeights) machine.sayHeights();
    machine.startup.onCodeFinished(step, machine.now_s);
  }
  return codes;
}

/// A start-up of which every step but one takes its time, and thirty hours after it.
std::string dayWithout(const std::string& omitted, const SettingTexts& set) {
  StartedMachine machine(gantryWith(set));
  std::string text;
  for (const StartupStatus& status : machine.startup.steps()) {
    if (toString(status.step) == omitted) continue;
    try {
      enter(machine, status.step);
      text += codesOf(machine, status.step);
    } catch (const Error& error) {
      text += std::string("rejected: ") + error.what() + "\n";
    }
    if (status.step == StartupStep::DryPellets) machine.letPass(4.1 * 3600.0);
    machine.letPass(60.0);
    text += statesOf(machine);
  }
  for (int hour = 0; hour < 30; ++hour) {
    machine.letPass(3600.0);
    text += machine.refusal() + "\n";
  }
  machine.startup.onCommandSent("M42 P1 S0");
  return text + statesOf(machine);
}

/// The bed heats by 5 K/min, then stays at 88.5 degC for two hours.
std::string weakBed(const SettingTexts& set) {
  StartedMachine machine(gantryWith(set));
  machine.perform(StartupStep::PowerOn);
  machine.startup.begin(StartupStep::HeatBed, 0.0);
  std::string text;
  for (int minute = 0; minute <= 120; ++minute) {
    machine.now_s = 60.0 * minute;
    machine.sayBed(std::min(20.0 + 5.0 * minute, 88.5));
    machine.startup.onCodeFinished(StartupStep::HeatBed, machine.now_s);
    text += machine.reasonOf(StartupStep::HeatBed) + "\n";
  }
  return text;
}

/// A dryer that reports 70 degC for five hours.
std::string dryer(const SettingTexts& set) {
  StartedMachine machine(gantryWith(set));
  enter(machine, StartupStep::DryPellets);
  std::string text = machine.startup.nextCode(StartupStep::DryPellets).value_or("nothing sent") + "\n";
  for (int i = 0; i < 30; ++i) {
    machine.now_s += 600.0;
    machine.say("T:25.00 /0.00 B:25.00 /0.00 C:70.00 /80.00");
    text += machine.reasonOf(StartupStep::DryPellets) + "\n";
  }
  return text;
}

SettingProbe dayProbe() {
  return {"a start-up",
          "",
          [](const SettingTexts& set) { return dayWithout("", set); },
          {{"startup.sequence=power_on heat_bed home_x"},
           {"startup.skip=map_heights"},
           {"startup.check_code=M105"},
           {"startup.dry_h=5"},
           {"startup.dry_valid_h=12"},
           {"startup.bed_code=M190 S{target_c}"},
           {"startup.bed_target_c=80"},
           {"startup.bed_tolerance_c=0.1"},
           {"startup.bed_rate_c_min=2"},
           {"startup.home_code=G28.1 {axis}"},
           {"startup.home_label=axes:"},
           {"startup.map_code=G29 T"},
           {"startup.map_flat_mm=0.1"},
           {"startup.map_valid_h=5"},
           {"startup.vacuum_zones=1 2"},
           {"startup.vacuum_on_code=M42 P{zone} S1"},
           {"startup.vacuum_off_code=M43 P{zone} S0"},
           {"startup.vacuum_label=area {zone}:"},
           {"startup.vacuum_max_kpa=20"},
           {"startup.vacuum_evacuate_s=45"},
           {"startup.vacuum_hold_s=45"}}};
}

SettingProbe orderProbe() {
  SettingProbe probe{"a start-up with wet pellets",
                     "",
                     [](const SettingTexts& set) { return dayWithout("dry_pellets", set); },
                     {}};
  for (const char* row :
       {"startup.after_power_on=dry_pellets", "startup.after_heat_bed=dry_pellets",
        "startup.after_home_x=dry_pellets", "startup.after_home_y=dry_pellets",
        "startup.after_home_z=dry_pellets", "startup.after_place_sheet=dry_pellets",
        "startup.after_draw_vacuum=dry_pellets", "startup.after_home_z_again=dry_pellets",
        "startup.after_map_heights=dry_pellets", "startup.after_transfer_program=dry_pellets"})
    probe.rows.push_back({row});
  return probe;
}

}  // namespace

std::vector<SettingProbe> startupProbes() {
  return {dayProbe(),
          orderProbe(),
          {"a start-up without power",
           "startup.after_home_x=;startup.sequence=power_on dry_pellets",
           [](const SettingTexts& set) { return dayWithout("power_on", set); },
           {{"startup.after_dry_pellets=power_on"}}},
          {"a weak bed",
           "startup.bed_max_rate_c_min=10",
           weakBed,
           {{"startup.bed_max_rate_c_min=4"}, {"startup.bed_timeout_min=90"}, {"startup.bed_tolerance_c=2"}}},
          {"a dryer",
           "startup.dry_label=C:;startup.dry_code=M141 S{target_c}",
           dryer,
           {{"startup.dry_label="},
            {"startup.dry_code="},
            {"startup.dry_tolerance_c=5"},
            {"startup.dry_target_c=100"}}},
          {"an aborted start-up",
           "startup.check_interval_s=60;startup.speed_up=1000",
           lastAfterAbort,
           {{"startup.abort_code=M117 aborted"}}},
          {"a machine that is looked at",
           "startup.check_interval_s=0.02;startup.speed_up=1000",
           looksInASecond,
           {{"startup.check_interval_s=60"}}},
          {"a clock", "startup.dry_h=0.01", driedInASecond, {{"startup.speed_up=1000"}}}};
}

}  // namespace lamina::test
