// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What every kind of device keeps to, and what is each kind's own.
#include "lamina/process_io/devices/process_device.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/process_io/devices/emulated_coupler.hpp"
#include "tty_device.hpp"

namespace lamina {
namespace {

constexpr double kTimeout = 2.0;  // s: the other end is a thread, which a loaded host may keep waiting

/// A device under test and what is at its other end.
class DeviceEnd {
 public:
  virtual ~DeviceEnd() = default;
  virtual DeviceTable table() const = 0;
  /// What has arrived of the two channels.
  virtual std::vector<double> arrived() = 0;
  /// The other end is gone, or is silent.
  virtual void cut() = 0;
};

DeviceTable tableOfTwo(DeviceKind kind, const std::string& address) {
  DeviceTable table;
  table.device.name = "device";
  table.device.kind = kind;
  table.device.address = address;
  table.device.timeout_s = kTimeout;
  OutputChannel channel;
  channel.high = 2000.0;
  channel.name = "first";
  channel.write = "0";
  table.channels.push_back(channel);
  channel.name = "second";
  channel.write = "1";
  table.channels.push_back(channel);
  return table;
}

ModbusServerSettings anyPort() {
  ModbusServerSettings server;
  server.port = 0;
  return server;
}

DeviceTable tableOfTwo(const CouplerServer& coupler) {
  return tableOfTwo(DeviceKind::ModbusTcp, "127.0.0.1:" + std::to_string(coupler.port()));
}

class TcpEnd final : public DeviceEnd {
 public:
  TcpEnd() {
    ModbusServerSettings server;
    server.port = 0;
    coupler_ = std::make_unique<CouplerServer>(CouplerSettings(), server);
    address_ = "127.0.0.1:" + std::to_string(coupler_->port());
  }
  DeviceTable table() const override { return tableOfTwo(DeviceKind::ModbusTcp, address_); }
  std::vector<double> arrived() override { return {1.0 * coupler_->at(0), 1.0 * coupler_->at(1)}; }
  void cut() override { coupler_.reset(); }

 private:
  std::unique_ptr<CouplerServer> coupler_;
  std::string address_;
};

class RtuEnd final : public DeviceEnd {
 public:
  DeviceTable table() const override { return tableOfTwo(DeviceKind::ModbusRtu, tty_.path()); }
  std::vector<double> arrived() override { return {1.0 * registers_.at(0), 1.0 * registers_.at(1)}; }
  void cut() override { tty_.mute(); }

 private:
  test::RtuRegisters registers_;
  test::TtyDevice tty_{[this](std::string& received) { return registers_.answer(received); }};
};

/// Takes "M<n> S<value>" and answers ok.
class TextEnd final : public DeviceEnd {
 public:
  DeviceTable table() const override {
    DeviceTable table = tableOfTwo(DeviceKind::SerialText, tty_.path());
    table.device.answer = "ok";
    table.channels[0].write = "M3 S{value}";
    table.channels[1].write = "M4 S{value} ; second";
    return table;
  }
  std::vector<double> arrived() override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return arrived_;
  }
  void cut() override { tty_.mute(); }
  std::vector<std::string> lines() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return lines_;
  }
  /// Neither takes nor answers lines of the first channel from now on.
  void refuseFirst() {
    const std::lock_guard<std::mutex> lock(mutex_);
    refuses_first_ = true;
  }

 private:
  std::string take(std::string& received) {
    std::string answers;
    for (std::size_t end; (end = received.find('\n')) != std::string::npos; received.erase(0, end + 1)) {
      const std::lock_guard<std::mutex> lock(mutex_);
      lines_.push_back(received.substr(0, end));
      const bool is_first = received[1] == '3';
      if (is_first && refuses_first_) continue;
      arrived_.at(is_first ? 0 : 1) = std::stod(received.substr(4));
      answers += "ok\n";
    }
    return answers;
  }

  std::mutex mutex_;
  std::vector<double> arrived_ = {0.0, 0.0};
  std::vector<std::string> lines_;
  bool refuses_first_ = false;
  test::TtyDevice tty_{[this](std::string& received) { return take(received); }};
};

std::vector<std::unique_ptr<DeviceEnd>> allEnds() {
  std::vector<std::unique_ptr<DeviceEnd>> ends;
  ends.push_back(std::make_unique<TcpEnd>());
  ends.push_back(std::make_unique<RtuEnd>());
  ends.push_back(std::make_unique<TextEnd>());
  return ends;
}

TEST(ProcessDeviceContract, ValuesArriveAndTheDeviceCanBeOpenedAgain) {
  for (const auto& end : allEnds()) {
    const auto device = makeProcessDevice(end->table());
    for (const double value : {1200.0, 7.0}) {
      device->open();
      device->exchange({value, 3.0});
      EXPECT_EQ(end->arrived(), (std::vector<double>{value, 3.0})) << end->table().device.address;
      device->exchange({value, 0.0});
      EXPECT_EQ(end->arrived(), (std::vector<double>{value, 0.0}));
      device->close();
      device->close();
    }
  }
}

TEST(ProcessDeviceContract, ALostDeviceIsNoticedAndNamed) {
  for (const auto& end : allEnds()) {
    const auto device = makeProcessDevice(end->table());
    device->open();
    device->exchange({1.0, 2.0});
    end->cut();
    try {
      device->exchange({5.0, 6.0});
      FAIL() << end->table().device.address;
    } catch (const Disconnected& error) {
      EXPECT_NE(std::string(error.what()).find("device"), std::string::npos) << error.what();
    }
    EXPECT_THROW(device->exchange({5.0, 6.0}), Disconnected);
  }
}

TEST(ProcessDeviceContract, ADeviceThatIsNotThereCannotBeOpened) {
  for (const DeviceKind kind : {DeviceKind::ModbusTcp, DeviceKind::ModbusRtu, DeviceKind::SerialText}) {
    const bool is_tcp = kind == DeviceKind::ModbusTcp;
    DeviceTable table = tableOfTwo(kind, is_tcp ? "127.0.0.1:1" : "/dev/there-is-none");
    if (kind == DeviceKind::SerialText)
      for (OutputChannel& channel : table.channels) channel.write = "S{value}";
    const auto device = makeProcessDevice(table);
    EXPECT_THROW(device->open(), Disconnected);
    EXPECT_THROW(device->exchange({0.0, 0.0}), Disconnected);
  }
}

TEST(ProcessDeviceContract, WhatIsNoDeviceTakesEverything) {
  const auto device = makeProcessDevice(tableOfTwo(DeviceKind::None, ""));
  EXPECT_EQ(device->open(), "device is no device: its values go nowhere");
  EXPECT_TRUE(device->exchange({1.0, 2.0}).empty());
  device->close();
}

TEST(ProcessDevice, InputsAreReadWithTheSameRequest) {
  CouplerServer coupler({}, anyPort());
  DeviceTable table = tableOfTwo(coupler);
  InputChannel input;
  input.read = kCouplerEffects + 1;
  table.inputs.push_back(input);
  input.read = kCouplerEffects;
  table.inputs.push_back(input);
  const auto device = makeProcessDevice(table);
  device->open();
  EXPECT_EQ(device->exchange({11.0, 22.0}), (std::vector<double>{22.0, 11.0}));
}

TEST(ProcessDevice, InputsAreReadWithTheirSign) {
  CouplerServer coupler({}, anyPort());
  DeviceTable table = tableOfTwo(coupler);
  InputChannel input;
  input.read = kCouplerEffects;
  table.inputs.push_back(input);
  input.is_signed = true;
  table.inputs.push_back(input);
  input.read = kCouplerEffects + 1;
  table.inputs.push_back(input);
  const auto device = makeProcessDevice(table);
  device->open();
  EXPECT_EQ(device->exchange({-5.0, 32767.0}), (std::vector<double>{65531.0, -5.0, 32767.0}));
}

TEST(ProcessDevice, TheWatchdogAndFaultValuesOfACouplerAreReadBack) {
  CouplerSettings settings;
  settings.watchdog_s = 0.4;
  CouplerServer coupler(settings, anyPort());
  DeviceTable table = tableOfTwo(coupler);
  EXPECT_EQ(makeProcessDevice(table)->open(),
            "device cannot report its watchdog: whether it goes safe by itself is not known");
  table.device.watchdog_register = kCouplerWatchdog;
  table.channels[0].fault_register = kCouplerFaultValues;
  EXPECT_EQ(makeProcessDevice(table)->open(), "");
  const auto refusal = [&table] {
    try {
      return makeProcessDevice(table)->open();
    } catch (const DeviceError& error) {
      return std::string(error.what());
    }
  };
  table.device.watchdog_unit_s = 2e-3;
  EXPECT_EQ(refusal(), "the watchdog of device is 0.8 s; expected above 0 and at most 0.5 s");
  table.device.watchdog_unit_s = 1e-3;
  table.device.watchdog_most_s = 0.3;
  EXPECT_EQ(refusal(), "the watchdog of device is 0.4 s; expected above 0 and at most 0.3 s");
  table.channels[0].safe = 5.0;
  EXPECT_EQ(refusal(), "device would set first to 0 when its link is lost; expected 5 in register 80");
}

TEST(ProcessDevice, LinesAreSentWhenTheyChange) {
  TextEnd end;
  const auto device = makeProcessDevice(end.table());
  device->open();
  device->exchange({1.5, 0.0004});
  device->exchange({1.5, 12.3456});
  const std::vector<std::string> lines = end.lines();
  EXPECT_EQ(lines[0], "M3 S1.5");
  EXPECT_EQ(lines[1], "M4 S0 ; second");
  // The first may have been repeated on a slow host.
  EXPECT_EQ(lines.back(), "M4 S12.346 ; second");
}

TEST(ProcessDevice, AChannelThatIsRefusedLeavesNoOtherOneOn) {
  TextEnd end;
  DeviceTable table = end.table();
  table.channels[1].safe = 3.0;
  const auto device = makeProcessDevice(table);
  device->open();
  device->exchange({1.0, 7.0});
  ASSERT_EQ(end.arrived(), (std::vector<double>{1.0, 7.0}));
  end.refuseFirst();
  EXPECT_THROW(device->exchange({2.0, 7.0}), Disconnected);
  // Nobody waits for what is answered to it.
  const SteadyClock clock;
  for (const double until_s = clock.now() + 60.0; end.arrived()[1] != 3.0 && clock.now() < until_s;)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(end.arrived(), (std::vector<double>{1.0, 3.0}));
}

std::string refusalOf(const DeviceTable& table) {
  try {
    makeProcessDevice(table);
    return "accepted";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

TEST(ProcessDevice, TablesThatDoNotFitAreRefused) {
  const DeviceTable well = tableOfTwo(DeviceKind::ModbusTcp, "127.0.0.1:502");
  EXPECT_EQ(refusalOf(well), "accepted");
  DeviceTable table = well;
  table.device.address = "127.0.0.1";
  EXPECT_EQ(refusalOf(table), "devices.device: address is '127.0.0.1'; must be host:port");
  table = well;
  table.channels[1].write = "two";
  EXPECT_EQ(refusalOf(table), "channels.second: write is 'two'; must be a register in [0, 65535]");
  table = well;
  table.channels[1].write = "2";
  EXPECT_EQ(refusalOf(table),
            "devices.device: registers 0 and 2 are written; must be each once and without a gap");
  table = well;
  table.channels[0].scale = 40.0;
  EXPECT_EQ(refusalOf(table),
            "channels.first: a value of 2000 is 80000 in a register; must be in [-32768, 65535]");
  table = well;
  table.channels.clear();
  EXPECT_EQ(refusalOf(table), "devices.device has no channel; must have one at least");
  table = well;
  table.inputs.resize(2);
  table.inputs[1].read = 200;
  EXPECT_EQ(refusalOf(table), "devices.device is read from register 0 to 200; must be at most 125 registers");
  EXPECT_EQ(refusalOf(tableOfTwo(DeviceKind::SerialText, "/dev/ttyUSB0")),
            "channels.first: write is '0'; must be a line with {value}");
}

TEST(ProcessDevice, ATableHasTheRowsOfItsDevice) {
  ProcessTables tables;
  tables.devices.resize(2);
  tables.devices[0].name = "a";
  tables.devices[1].name = "b";
  tables.devices[1].kind = DeviceKind::ModbusTcp;
  tables.channels.resize(3);
  tables.channels[0].device = "b";
  tables.channels[1].device = "a";
  tables.channels[2].device = "b";
  tables.inputs.resize(1);
  tables.inputs[0].device = "b";
  EXPECT_EQ(tableOf(tables, 1).channels.size(), 2U);
  EXPECT_EQ(tableOf(tables, 1).inputs.size(), 1U);
  EXPECT_EQ(tableOf(tables, 0).channels.size(), 1U);
  tables.inputs[0].device = "a";
  EXPECT_THROW(tableOf(tables, 0), InvalidConfig);
}

}  // namespace
}  // namespace lamina
