// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The unit's link to a PLC, and what the unit does beside it.
#include "lamina/modbus/plc_link.hpp"
#include "nodes/cell_controller/cell_settings.hpp"
#include "nodes/plc_link/link_settings.hpp"
#include "ros/settings/node_probes.hpp"

namespace lamina::test {
namespace {

/// When the heartbeat of a PLC that beats for the last time at 1 s is lost, and abandoned; and a long word.
std::string silentPlc(const SettingTexts& set) {
  PlcLink link(settingsWith<LinkSettings>(set).link);
  link.setRemoteAccess(RemoteAccess::Allowed);
  link.setPresence(UnitPresence::Present, 0.0);
  for (std::uint16_t beat = 1; beat <= 2; ++beat) {
    ModbusRequest request;
    request.function = ModbusFunction::WriteMany;
    request.written = {beat};
    link.answer(1, request, beat - 1.0);
  }
  std::string text;
  PlcHeartbeat last = PlcHeartbeat::Unarmed;
  for (int i = 0; i <= 8000; ++i) {
    const PlcHeartbeat now = link.watch(1.0 + 0.05 * i);
    if (now != last) text += std::to_string(int(now)) + " at " + numbersText({0.05 * i});
    last = now;
  }
  return text + numbersText({double(link.registers(0.0)[4])});
}

std::string serverOfLink(const SettingTexts& set) {
  const ModbusServerSettings server = serverSettings(settingsWith<LinkSettings>(set));
  std::string text = server.bind + " " + numbersText({double(server.port), double(server.connections)});
  for (const std::string& address : server.allow) text += address + "\n";
  return text;
}

PlcReport goodPlc() {
  PlcReport report;
  report.heartbeat = PlcHeartbeat::Good;
  report.interlocks = {true, true, true, true, true, true, true, false, false, false};
  report.is_plate_written = report.is_guard_closed = true;
  return report;
}

/// What is demanded of a unit that runs, by a PLC that has gas from 5 s on and falls silent after 10 s.
std::string demandsOfPlc(const SettingTexts& set) {
  PlcWatch watch(settingsWith<CellControllerSettings>(set).plc);
  UnitStatus unit;
  unit.state = UnitState::Execute;
  std::string text;
  for (int i = 0; i < 100; ++i) {
    PlcReport report = goodPlc();
    report.interlocks.has_gas = i >= 5;
    if (i > 10) report.heartbeat = PlcHeartbeat::Unarmed;
    watch.hear(report, i);
    const PlcDemands demands = watch.demands(unit, i);
    for (const PlcAlarm& alarm : demands.raised)
      text += std::to_string(i) + " s: " + std::to_string(alarm.id) + "\n";
  }
  return text + "watched";
}

/// Whether a unit goes on that the PLC has suspended.
std::string goesOn(const SettingTexts& set) {
  PlcWatch watch(settingsWith<CellControllerSettings>(set).plc);
  watch.hear(goodPlc(), 0.0);
  UnitStatus unit;
  unit.state = UnitState::Suspended;
  unit.sequence = 7;
  unit.stop_reason = ActiveAlarm{};
  unit.stop_reason->id = 1204;
  return watch.demands(unit, 0.0).command ? "it goes on" : "it stays";
}

}  // namespace

std::vector<SettingProbe> plcProbes() {
  return {{"a PLC that falls silent",
           "",
           silentPlc,
           {{"modbus.watchdog_s=4"}, {"modbus.abandon_s=100"}, {"modbus.word_order=low_first"}}},
          {"where the link listens",
           "",
           serverOfLink,
           {{"modbus.bind=127.0.0.2"},
            {"modbus.port=1503"},
            {"modbus.connections=2"},
            {"modbus.allow=192.0.2.1, 127.0.0.1"}}},
          {"what a PLC demands",
           "",
           demandsOfPlc,
           {{"plc.required=true"}, {"plc.patience_s=40", "plc.required=true"}}},
          {"a unit that the PLC has suspended", "", goesOn, {{"plc.unsuspends=false"}}},
          {"a unit whose emergency stop was pressed",
           "",
           [](const SettingTexts& set) {
             const bool is_local =
                 demandsLocalStart({1207, "pressed"}, settingsWith<CellControllerSettings>(set));
             return std::string(is_local ? "somebody else starts it" : "the PLC may start it");
           },
           {{"start.local_after_estop=false"}}}};
}

}  // namespace lamina::test
