// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "lamina/process_io/process_tables.hpp"

namespace lamina {

/// The rows of the tables that belong to one device.
struct DeviceTable {
  DeviceSettings device;
  std::vector<OutputChannel> channels;
  std::vector<InputChannel> inputs;
};

/// The rows of one device.
/// @param device  index in the tables
DeviceTable tableOf(const ProcessTables& tables, std::size_t device);

/// The raw value that is sent to a device for a value of a channel.
inline double rawOf(const OutputChannel& channel, double value) {
  return channel.scale * value + channel.offset;
}

/// The value of an input, from the raw value that a device reads.
inline double valueOf(const InputChannel& input, double raw) { return (raw - input.offset) / input.scale; }

/// Interface to a device. Calls come from one thread, and may wait for the device's `timeout_s`.
class ProcessDevice {
 public:
  virtual ~ProcessDevice() = default;

  /// Connects to the device, and checks its behaviour on loss of the link, as far as the device reports it.
  /// @return a warning in words; empty if there is none
  /// @throws Disconnected if the device does not answer
  /// @throws DeviceError, with the report of the device, if the device would not go to safe values by itself
  ///   when the link is lost
  virtual std::string open() = 0;

  /// Writes all channels and reads all inputs, raw, in the order of the device's table.
  /// @throws Disconnected if that fails; the device must then be opened again
  virtual std::vector<double> exchange(const std::vector<double>& raw) = 0;

  virtual void close() = 0;
};

/// A device of one of the kinds modbus_tcp, modbus_rtu, serial_text and none; null for kinds that need ROS.
/// @throws InvalidConfig if the table does not fit the kind, naming row, value and what was expected
std::unique_ptr<ProcessDevice> makeProcessDevice(const DeviceTable& table);

}  // namespace lamina
