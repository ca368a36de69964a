// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "lamina/process_io/process_tables.hpp"

namespace lamina {

/// What stands in the tables of one device.
struct DeviceTable {
  DeviceSettings device;
  std::vector<OutputChannel> channels;
  std::vector<InputChannel> inputs;
};

/// @param device  index in the tables
DeviceTable tableOf(const ProcessTables& tables, std::size_t device);

/// The value that a device is sent for a value of a channel.
inline double rawOf(const OutputChannel& channel, double value) {
  return channel.scale * value + channel.offset;
}

/// The value of an input that a device reads as that.
inline double valueOf(const InputChannel& input, double raw) { return (raw - input.offset) / input.scale; }

/// The link to a device. Calls come from one thread, and may wait for the device's `timeout_s`.
class ProcessDevice {
 public:
  virtual ~ProcessDevice() = default;

  /// Connects, and reads back what the device does when the link is lost, where it can report that.
  /// @return what is to be warned of, in words; empty if nothing is
  /// @throws Disconnected if it is not there
  /// @throws DeviceError if it does not go safe by itself as it should, with what it reports
  virtual std::string open() = 0;

  /// Writes all channels and reads all inputs, raw, in the order of the device's table.
  /// @throws Disconnected if that fails; it must be opened again
  virtual std::vector<double> exchange(const std::vector<double>& raw) = 0;

  virtual void close() = 0;
};

/// Of the kinds modbus_tcp, modbus_rtu, serial_text and none; null for those that need ROS.
/// @throws InvalidConfig if the table does not fit the kind, naming row, value and what was expected
std::unique_ptr<ProcessDevice> makeProcessDevice(const DeviceTable& table);

}  // namespace lamina
