// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "process_io/devices/modbus_device.hpp"

#include <modbus/modbus.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

// Of one request of function 23.
constexpr int kMostWritten = 121;
constexpr int kMostRead = 125;
constexpr double kLeastRaw = -32768.0;
constexpr double kMostRaw = 65535.0;

/// Registers that lie side by side.
struct RegisterBlock {
  int first = 0;
  int count = 0;
};

int registerOf(const OutputChannel& channel) {
  int value = -1;
  const std::string& text = channel.write;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || value < 0 || value > 65535)
    throw InvalidConfig("channels." + channel.name + ": write is '" + text +
                        "'; must be a register in [0, 65535]");
  return value;
}

/// Every value of a channel fits a register: unsigned, or as a two's complement.
void requireFitting(const OutputChannel& channel) {
  for (const double value : {channel.low, channel.high, channel.safe}) {
    const double raw = rawOf(channel, value);
    if (!(raw >= kLeastRaw && raw <= kMostRaw))
      throw InvalidConfig("channels." + channel.name + ": a value of " + numberText(value) + " is " +
                          numberText(raw) + " in a register; must be in [-32768, 65535]");
  }
}

RegisterBlock outputsOf(const DeviceTable& table) {
  std::vector<int> registers;
  for (const OutputChannel& channel : table.channels) {
    requireFitting(channel);
    registers.push_back(registerOf(channel));
  }
  if (registers.empty())
    throw InvalidConfig("devices." + table.device.name + " has no channel; must have one at least");
  std::sort(registers.begin(), registers.end());
  for (std::size_t i = 1; i < registers.size(); ++i)
    if (registers[i] != registers[i - 1] + 1)
      throw InvalidConfig("devices." + table.device.name + ": registers " + std::to_string(registers[i - 1]) +
                          " and " + std::to_string(registers[i]) +
                          " are written; must be each once and without a gap");
  const auto count = static_cast<int>(registers.size());
  if (count > kMostWritten)
    throw InvalidConfig("devices." + table.device.name + " has " + std::to_string(count) +
                        " channels; must be at most " + std::to_string(kMostWritten));
  return {registers.front(), count};
}

RegisterBlock inputsOf(const DeviceTable& table) {
  if (table.inputs.empty()) return {};
  const auto [least, most] =
      std::minmax_element(table.inputs.begin(), table.inputs.end(),
                          [](const InputChannel& a, const InputChannel& b) { return a.read < b.read; });
  const int count = most->read - least->read + 1;
  if (count > kMostRead)
    throw InvalidConfig("devices." + table.device.name + " is read from register " +
                        std::to_string(least->read) + " to " + std::to_string(most->read) +
                        "; must be at most " + std::to_string(kMostRead) + " registers");
  return {least->read, count};
}

struct Freed {
  void operator()(modbus_t* context) const { modbus_free(context); }
};
using Context = std::unique_ptr<modbus_t, Freed>;

Context contextOf(const DeviceSettings& device) {
  if (device.kind == DeviceKind::ModbusRtu) {
    const char parity = device.parity == Parity::None ? 'N' : device.parity == Parity::Even ? 'E' : 'O';
    return Context(modbus_new_rtu(device.address.c_str(), device.baud, parity, 8, 1));
  }
  const std::size_t colon = device.address.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == device.address.size())
    throw InvalidConfig("devices." + device.name + ": address is '" + device.address +
                        "'; must be host:port");
  return Context(
      modbus_new_tcp_pi(device.address.substr(0, colon).c_str(), device.address.substr(colon + 1).c_str()));
}

class ModbusDevice final : public ProcessDevice {
 public:
  explicit ModbusDevice(const DeviceTable& table)
      : table_(table),
        outputs_(outputsOf(table)),
        inputs_(inputsOf(table)),
        context_(contextOf(table.device)) {
    const DeviceSettings& device = table.device;
    if (!context_ || modbus_set_slave(context_.get(), device.unit) != 0)
      throw InvalidConfig("devices." + device.name + ": '" + device.address + "' with unit " +
                          std::to_string(device.unit) + " is no Modbus device");
    const auto microseconds = static_cast<std::uint32_t>(1e6 * device.timeout_s);
    modbus_set_response_timeout(context_.get(), microseconds / 1000000, microseconds % 1000000);
  }
  ~ModbusDevice() override { ModbusDevice::close(); }

  std::string open() override {
    close();
    if (modbus_connect(context_.get()) != 0) fail("cannot be connected to");
    is_open_ = true;
    requireFaultValues();
    return watchdog();
  }

  std::vector<double> exchange(const std::vector<double>& raw) override {
    // libmodbus itself would write to a descriptor that is none.
    if (!is_open_) throw Disconnected(table_.device.name + " is not open");
    std::vector<std::uint16_t> written(static_cast<std::size_t>(outputs_.count));
    for (std::size_t i = 0; i < raw.size(); ++i) {
      const auto at = static_cast<std::size_t>(registerOf(table_.channels[i]) - outputs_.first);
      written[at] = static_cast<std::uint16_t>(std::lround(raw[i]));
    }
    const std::vector<std::uint16_t> read = transfer(written);
    std::vector<double> inputs;
    for (const InputChannel& input : table_.inputs) {
      const std::uint16_t raw_input = read[static_cast<std::size_t>(input.read - inputs_.first)];
      inputs.push_back(input.is_signed ? static_cast<std::int16_t>(raw_input) : raw_input);
    }
    return inputs;
  }

  void close() override {
    if (std::exchange(is_open_, false)) modbus_close(context_.get());
  }

 private:
  std::vector<std::uint16_t> transfer(const std::vector<std::uint16_t>& written) {
    std::vector<std::uint16_t> read(static_cast<std::size_t>(inputs_.count));
    const int done =
        inputs_.count > 0
            ? modbus_write_and_read_registers(context_.get(), outputs_.first, outputs_.count, written.data(),
                                              inputs_.first, inputs_.count, read.data())
            : modbus_write_registers(context_.get(), outputs_.first, outputs_.count, written.data());
    if (done < 0) fail("does not take its values");
    return read;
  }

  std::uint16_t readOne(int address) {
    std::uint16_t value = 0;
    if (modbus_read_registers(context_.get(), address, 1, &value) != 1)
      fail("does not report register " + std::to_string(address));
    return value;
  }

  /// What the device's outputs become by themselves must be safe.
  void requireFaultValues() {
    for (const OutputChannel& channel : table_.channels) {
      if (channel.fault_register < 0) continue;
      const auto expected = static_cast<std::uint16_t>(std::lround(rawOf(channel, channel.safe)));
      const std::uint16_t fault_value = readOne(channel.fault_register);
      if (fault_value != expected)
        throw DeviceError(table_.device.name + " would set " + channel.name + " to " +
                          std::to_string(fault_value) + " when its link is lost; expected " +
                          std::to_string(expected) + " in register " +
                          std::to_string(channel.fault_register));
    }
  }

  std::string watchdog() {
    const DeviceSettings& device = table_.device;
    if (device.watchdog_register < 0)
      return device.name + " cannot report its watchdog: whether it goes safe by itself is not known";
    const double time_s = device.watchdog_unit_s * readOne(device.watchdog_register);
    if (time_s > 0.0 && time_s <= device.watchdog_most_s) return {};
    throw DeviceError("the watchdog of " + device.name + " is " + numberText(time_s) +
                      " s; expected above 0 and at most " + numberText(device.watchdog_most_s) + " s");
  }

  [[noreturn]] void fail(const std::string& what) {
    const std::string reason = modbus_strerror(errno);
    close();
    throw Disconnected(table_.device.name + " at " + table_.device.address + " " + what + ": " + reason);
  }

  DeviceTable table_;
  RegisterBlock outputs_;
  RegisterBlock inputs_;
  Context context_;
  bool is_open_ = false;
};

}  // namespace

std::unique_ptr<ProcessDevice> makeModbusDevice(const DeviceTable& table) {
  return std::make_unique<ModbusDevice>(table);
}

}  // namespace lamina
