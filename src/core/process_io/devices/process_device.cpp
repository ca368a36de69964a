// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/devices/process_device.hpp"

#include <algorithm>
#include <iterator>

#include "lamina/base/error.hpp"
#include "process_io/devices/modbus_device.hpp"
#include "process_io/devices/serial_text_device.hpp"

namespace lamina {
namespace {

/// Takes everything and does nothing with it.
class NoDevice final : public ProcessDevice {
 public:
  explicit NoDevice(std::string name) : name_(std::move(name)) {}
  std::string open() override { return name_ + " is no device: its values go nowhere"; }
  std::vector<double> exchange(const std::vector<double>&) override { return {}; }
  void close() override {}

 private:
  std::string name_;
};

}  // namespace

DeviceTable tableOf(const ProcessTables& tables, std::size_t device) {
  DeviceTable table;
  table.device = tables.devices[device];
  const auto is_of_it = [&table](const auto& row) { return row.device == table.device.name; };
  std::copy_if(tables.channels.begin(), tables.channels.end(), std::back_inserter(table.channels), is_of_it);
  std::copy_if(tables.inputs.begin(), tables.inputs.end(), std::back_inserter(table.inputs), is_of_it);
  const bool is_read =
      table.device.kind == DeviceKind::ModbusTcp || table.device.kind == DeviceKind::ModbusRtu;
  if (!is_read && !table.inputs.empty())
    throw InvalidConfig("inputs." + table.inputs.front().name + ": device is '" + table.device.name +
                        "', which is only written; must be one of modbus_tcp or modbus_rtu");
  return table;
}

std::unique_ptr<ProcessDevice> makeProcessDevice(const DeviceTable& table) {
  switch (table.device.kind) {
    case DeviceKind::ModbusTcp:
    case DeviceKind::ModbusRtu:
      return makeModbusDevice(table);
    case DeviceKind::SerialText:
      return makeSerialTextDevice(table);
    case DeviceKind::None:
      return std::make_unique<NoDevice>(table.device.name);
    default:
      return nullptr;
  }
}

}  // namespace lamina
