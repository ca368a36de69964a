// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What carries the plan of a process to its devices, and a coupler that is not there.
#include "lamina/base/error.hpp"
#include "nodes/emulated_coupler/coupler_settings.hpp"
#include "nodes/process_io/process_io_settings.hpp"
#include "ros/settings/node_probes.hpp"

namespace lamina::test {
namespace {

constexpr char kLaserAlone[] =
    "devices={source: {kind: modbus_tcp, address: \"plc:502\"}};"
    "channels={laser: {quantity: laser_power_w, device: source, low: 200, high: 2000}};"
    "inputs={power: {device: source, read: 7, check: follows, channel: laser, tolerance: 50, after_s: 0.1}}";

/// Alarms and values of a laser that is on for two seconds, whose outputs come the later the longer that is,
/// on a machine that stands still from the first second on; its device comes after 0.5 s.
std::string carried(const SettingTexts& set) {
  const auto settings = settingsWith<ProcessIoSettings>(set);
  const ProcessTables tables = processTables(settings.tables);
  ProcessBridge bridge(tables, settings.bridge, 0.0);
  ProcessSignals on;
  on.is_laser_on = true;
  on.levels[ProcessLevel::LaserPower] = 2500.0;
  std::string text = tables.devices.front().address;
  for (int i = 1; i <= 500; ++i) {
    const double now_s = 0.01 * i;
    if (i == 200) bridge.accept({{{now_s, on}, {now_s + 2.0, on}}, now_s + 2.0}, now_s);
    bridge.updatePositions({{"x", i < 300 ? now_s : 3.0}}, now_s);
    const double measured = i == 220 ? 0.0 : 2000.0;
    const BridgeCycle cycle = bridge.cycle(now_s, {{{i > 50, "not there"}},
                                                   std::vector<double>(tables.inputs.size(), measured),
                                                   i > 230 && i < 300 ? 0.0002 * (i - 230) : 0.0});
    for (const ProcessAlarm& alarm : cycle.alarms)
      text += std::to_string(i) + ": " + std::to_string(alarm.id) + (alarm.is_gone ? " gone\n" : "\n");
    text += numbersText(cycle.values);
  }
  return text;
}

ModbusRequest writtenTo(std::uint16_t address, std::uint16_t value) {
  ModbusRequest request;
  request.function = ModbusFunction::WriteMany;
  request.write_address = address;
  request.written = {value};
  return request;
}

/// What becomes of an output of the coupler that is written once.
std::string coupled(const SettingTexts& set) {
  EmulatedCoupler coupler(settingsWith<EmulatedCouplerSettings>(set).coupler);
  coupler.answer(writtenTo(kCouplerOutputs, 1000), 1.0);
  std::vector<double> numbers;
  for (int i = 0; i < 40; ++i) numbers.push_back(coupler.at(kCouplerEffects, 1.0 + 0.05 * i));
  return numbersText(numbers);
}

}  // namespace

std::vector<SettingProbe> processIoProbes() {
  return {{"a laser",
           kLaserAlone,
           carried,
           {{"late_s=0.005"},
            {"too_late_s=0.008"},
            {"standstill_s=0.6"},
            {"connect_wait_s=0.2"},
            {"devices={source: {kind: modbus_tcp, address: \"plc:503\"}}"},
            {"channels={laser: {quantity: laser_power_w, device: source, low: 200, high: 4000}}"},
            {"inputs={power: {device: source, read: 7, check: follows, channel: laser, tolerance: 50}}"}}},
          {"a coupler", "", coupled, {{"watchdog_s=1"}, {"dead_time_s=0.2"}, {"lag_s=0.1"}}}};
}

}  // namespace lamina::test
