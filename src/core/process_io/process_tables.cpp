// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/process_tables.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kMost = 1e9;
constexpr double kRegisters = 65535.0;

std::vector<std::pair<std::string, ProcessQuantity>> quantities() {
  std::vector<std::pair<std::string, ProcessQuantity>> all;
  for (int i = 0; i <= static_cast<int>(ProcessQuantity::Fan); ++i) {
    const auto quantity = static_cast<ProcessQuantity>(i);
    all.emplace_back(nameOf(quantity), quantity);
  }
  return all;
}

void describeRow(SettingsSchema& schema, OutputChannel& channel) {
  schema.choice<ProcessQuantity>("quantity", channel.quantity, quantities(), "");
  schema.text("device", channel.device, "");
  schema.text("write", channel.write, "");
  schema.number("scale", channel.scale, {-kMost, kMost}, "");
  schema.number("offset", channel.offset, {-kMost, kMost}, "");
  schema.number("low", channel.low, {0.0, kMost}, "");
  schema.number("high", channel.high, Bounds::above(0.0, kMost), "");
  schema.number("safe", channel.safe, {0.0, kMost}, "");
  schema.number("nominal", channel.nominal, {0.0, kMost}, "");
  schema.number("slew_per_s", channel.slew_per_s, {0.0, kMost}, "");
  schema.number("dead_time_s", channel.dead_time_s, {0.0, 10.0}, "");
  schema.number("lag_s", channel.lag_s, {0.0, 10.0}, "");
  schema.number("wire_diameter_mm", channel.wire_diameter_mm, {0.0, 20.0}, "");
  schema.list("screw", channel.screw, Bounds::above(0.0, kMost), "");
  schema.integer("fault_register", channel.fault_register, {-1.0, kRegisters}, "");
}

void describeRow(SettingsSchema& schema, InputChannel& input) {
  schema.text("device", input.device, "");
  schema.integer("read", input.read, {0.0, kRegisters}, "");
  schema.flag("signed", input.is_signed, "");
  schema.number("scale", input.scale, {-kMost, kMost}, "");
  schema.number("offset", input.offset, {-kMost, kMost}, "");
  schema.choice<InputCheck>("check", input.check,
                            {{"shown", InputCheck::Shown},
                             {"follows", InputCheck::Follows},
                             {"present", InputCheck::Present},
                             {"ready", InputCheck::Ready}},
                            "");
  schema.text("channel", input.channel, "");
  schema.number("tolerance", input.tolerance, {0.0, kMost}, "");
  schema.number("least", input.least, {-kMost, kMost}, "");
  schema.number("after_s", input.after_s, {0.0, 60.0}, "");
}

void describeRow(SettingsSchema& schema, DeviceSettings& device) {
  schema.choice<DeviceKind>("kind", device.kind,
                            {{"modbus_tcp", DeviceKind::ModbusTcp},
                             {"modbus_rtu", DeviceKind::ModbusRtu},
                             {"serial_text", DeviceKind::SerialText},
                             {"set_io", DeviceKind::SetIo},
                             {"topic", DeviceKind::Topic},
                             {"none", DeviceKind::None}},
                            "");
  schema.text("address", device.address, "");
  schema.integer("baud", device.baud, {300.0, 4e6}, "");
  schema.choice<Parity>("parity", device.parity,
                        {{"none", Parity::None}, {"even", Parity::Even}, {"odd", Parity::Odd}}, "");
  schema.integer("unit", device.unit, {0.0, 255.0}, "");
  schema.number("timeout_s", device.timeout_s, {0.01, 5.0}, "");
  schema.number("retry_s", device.retry_s, {0.01, 60.0}, "");
  schema.text("answer", device.answer, "");
  schema.integer("watchdog_register", device.watchdog_register, {-1.0, kRegisters}, "");
  schema.number("watchdog_unit_s", device.watchdog_unit_s, Bounds::above(0.0, 60.0), "");
  schema.number("watchdog_most_s", device.watchdog_most_s, {0.01, 60.0}, "");
}

/// Rows of a table, each with its name, in the order of names.
template <class Row>
std::vector<Row> rowsOf(const std::string& table, const SettingTable& entries) {
  std::map<std::string, Row> rows;
  for (const auto& [entry, text] : entries) {
    const std::size_t dot = entry.find('.');
    if (dot == std::string::npos || dot == 0)
      throw InvalidConfig(table + "." + entry + " is '" + text + "'; must be a map of rows by their names");
    const std::string name = entry.substr(0, dot);
    Row& row = rows[name];
    row.name = name;
    SettingsSchema schema;
    describeRow(schema, row);
    try {
      schema.set(entry.substr(dot + 1), text);
    } catch (const InvalidConfig& error) {
      throw InvalidConfig(table + "." + name + ": " + error.what());
    }
  }
  std::vector<Row> list;
  list.reserve(rows.size());
  for (auto& [name, row] : rows) list.push_back(std::move(row));
  return list;
}

[[noreturn]] void refuseRow(const std::string& row, const std::string& why) {
  throw InvalidConfig(row + ": " + why);
}

void requireKnown(const std::string& row, const std::string& device, const ProcessTables& tables) {
  for (const DeviceSettings& known : tables.devices)
    if (known.name == device) return;
  refuseRow(row, "device is '" + device + "'; must be one of devices");
}

double flowOf(const std::vector<double>& screw, std::size_t entry) {
  return screw[2 * entry] * screw[2 * entry + 1] / 60.0;
}

void requireRising(const std::string& row, const std::vector<double>& screw) {
  if (screw.size() % 2 != 0)
    refuseRow(row, "screw has " + std::to_string(screw.size()) +
                       " numbers; must be pairs of rpm and mm3 per revolution");
  for (std::size_t i = 1; i < screw.size() / 2; ++i)
    if (!(screw[2 * i] > screw[2 * i - 2] && flowOf(screw, i) > flowOf(screw, i - 1)))
      refuseRow(row, "screw has " + numberText(flowOf(screw, i)) + " mm3/s at " + numberText(screw[2 * i]) +
                         " rpm behind " + numberText(flowOf(screw, i - 1)) + " mm3/s at " +
                         numberText(screw[2 * i - 2]) + " rpm; both must rise");
}

void requireUsable(const OutputChannel& channel, const ProcessTables& tables) {
  const std::string row = "channels." + channel.name;
  requireKnown(row, channel.device, tables);
  if (channel.scale == 0.0) refuseRow(row, "scale is 0; must be another number");
  if (!(channel.high > channel.low))
    refuseRow(row, "high is " + numberText(channel.high) + "; must be above low, " + numberText(channel.low));
  if (channel.safe > channel.high)
    refuseRow(row,
              "safe is " + numberText(channel.safe) + "; must be at most high, " + numberText(channel.high));
  if (channel.nominal > channel.high || (channel.nominal > 0.0 && channel.nominal < channel.low))
    refuseRow(row, "nominal is " + numberText(channel.nominal) + "; must be 0 or in [" +
                       numberText(channel.low) + ", " + numberText(channel.high) + "]");
  requireRising(row, channel.screw);
}

void requireUsable(const InputChannel& input, const ProcessTables& tables) {
  const std::string row = "inputs." + input.name;
  requireKnown(row, input.device, tables);
  if (input.scale == 0.0) refuseRow(row, "scale is 0; must be another number");
  if (input.check == InputCheck::Shown || input.check == InputCheck::Ready) return;
  const bool is_known = std::any_of(tables.channels.begin(), tables.channels.end(),
                                    [&](const OutputChannel& each) { return each.name == input.channel; });
  if (!is_known) refuseRow(row, "channel is '" + input.channel + "'; must be one of channels");
}

}  // namespace

const char* nameOf(ProcessQuantity quantity) {
  switch (quantity) {
    case ProcessQuantity::LaserOn:
      return "laser";
    case ProcessQuantity::LaserPower:
      return "laser_power_w";
    case ProcessQuantity::WireOn:
      return "wire";
    case ProcessQuantity::WireSpeed:
      return "wire_speed_mm_s";
    case ProcessQuantity::ScrewSpeed:
      return "screw_rpm";
    case ProcessQuantity::Flow:
      return "flow_mm3_s";
    case ProcessQuantity::PowderOn:
      return "powder";
    case ProcessQuantity::Powder:
      return "powder_g_min";
    case ProcessQuantity::GasOn:
      return "gas";
    case ProcessQuantity::Gas:
      return "gas_l_min";
    case ProcessQuantity::Fan:
      return "fan";
  }
  return "";
}

void describe(SettingsSchema& schema, ProcessTableSettings& settings) {
  schema.table("devices", settings.devices,
               "Devices by name: kind, address, baud, parity, unit, timeout_s, retry_s, answer, "
               "watchdog_register, watchdog_unit_s, watchdog_most_s.");
  schema.table("channels", settings.channels,
               "Outputs by name: quantity, device, write, scale, offset, low, high, safe, nominal, "
               "slew_per_s, dead_time_s, lag_s, wire_diameter_mm, screw, fault_register.");
  schema.table(
      "inputs", settings.inputs,
      "Inputs by name: device, read, signed, scale, offset, check, channel, tolerance, least, after_s.");
}

ProcessTables processTables(const ProcessTableSettings& settings) {
  ProcessTables tables;
  tables.devices = rowsOf<DeviceSettings>("devices", settings.devices);
  tables.channels = rowsOf<OutputChannel>("channels", settings.channels);
  tables.inputs = rowsOf<InputChannel>("inputs", settings.inputs);
  for (const OutputChannel& channel : tables.channels) requireUsable(channel, tables);
  for (const InputChannel& input : tables.inputs) requireUsable(input, tables);
  std::stable_sort(tables.channels.begin(), tables.channels.end(),
                   [](const auto& a, const auto& b) { return a.quantity < b.quantity; });
  return tables;
}

double screwSpeed(double flow_mm3_s, const std::vector<double>& screw) {
  if (!(flow_mm3_s > 0.0)) return 0.0;
  const std::size_t entries = screw.size() / 2;
  if (flow_mm3_s <= flowOf(screw, 0)) return 60.0 * flow_mm3_s / screw[1];
  if (flow_mm3_s >= flowOf(screw, entries - 1)) return 60.0 * flow_mm3_s / screw[2 * entries - 1];
  std::size_t above = 1;
  while (flowOf(screw, above) < flow_mm3_s) ++above;
  double slow = screw[2 * above - 2];
  double fast = screw[2 * above];
  const double slope = (screw[2 * above + 1] - screw[2 * above - 1]) / (fast - slow);
  const auto flow_at = [&](double rpm) {
    return rpm * (screw[2 * above - 1] + slope * (rpm - screw[2 * above - 2])) / 60.0;
  };
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (slow + fast);
    (flow_at(middle) < flow_mm3_s ? slow : fast) = middle;
  }
  return 0.5 * (slow + fast);
}

}  // namespace lamina
