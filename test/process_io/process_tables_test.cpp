// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/process_tables.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>
#include <sstream>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

ProcessTableSettings tables(const std::string& channel, const std::string& input = "") {
  ProcessTableSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  schema.set("devices", "{coupler: {kind: modbus_tcp, address: \"plc:502\"}}");
  schema.set("channels", "{gas: {quantity: gas, device: coupler, high: 1}, laser: " + channel + "}");
  if (!input.empty()) schema.set("inputs", "{seen: " + input + "}");
  return settings;
}

std::string refusal(const ProcessTableSettings& settings) {
  try {
    processTables(settings);
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return "accepted";
}

constexpr char kLaser[] =
    "{quantity: laser_power_w, device: coupler, write: 3, scale: 8.2, low: 200, high: 4000, lag_s: 0.02}";

TEST(ProcessTables, RowsAreReadTheBeamFirst) {
  const ProcessTables read = processTables(
      tables(kLaser, "{device: coupler, read: 7, check: follows, channel: laser, tolerance: 50}"));
  ASSERT_EQ(read.channels.size(), 2U);
  EXPECT_EQ(read.channels[0].name, "laser");
  EXPECT_EQ(read.channels[0].write, "3");
  EXPECT_EQ(read.channels[0].scale, 8.2);
  EXPECT_EQ(read.channels[0].low, 200.0);
  EXPECT_EQ(read.channels[0].high, 4000.0);
  EXPECT_EQ(read.channels[0].lag_s, 0.02);
  EXPECT_EQ(read.channels[1].quantity, ProcessQuantity::GasOn);
  ASSERT_EQ(read.inputs.size(), 1U);
  EXPECT_EQ(read.inputs[0].read, 7);
  EXPECT_EQ(read.inputs[0].check, InputCheck::Follows);
  EXPECT_EQ(read.devices[0].kind, DeviceKind::ModbusTcp);
  EXPECT_EQ(read.devices[0].address, "plc:502");
}

/// Keys of a row, as the meaning of its table lists them.
std::set<std::string> keysListed(const std::string& table) {
  ProcessTableSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  const std::string meaning = schema.find(table)->meaning;
  std::istringstream words(meaning.substr(meaning.find(':') + 1));
  std::set<std::string> keys;
  for (std::string word; words >> word;) keys.insert(word.substr(0, word.size() - 1));
  return keys;
}

/// Keys that are set of the row "a".
std::set<std::string> keysSet(const SettingTable& table) {
  std::set<std::string> keys;
  for (const auto& [entry, text] : table) keys.insert(entry.substr(2));
  return keys;
}

TEST(ProcessTables, EveryKeyOfADeviceIsRead) {
  ProcessTableSettings settings;
  settings.devices = {{"a.kind", "modbus_rtu"},
                      {"a.address", "/dev/ttyS1"},
                      {"a.baud", "9600"},
                      {"a.parity", "odd"},
                      {"a.unit", "7"},
                      {"a.timeout_s", "0.3"},
                      {"a.retry_s", "2.5"},
                      {"a.answer", "ok"},
                      {"a.watchdog_register", "64"},
                      {"a.watchdog_unit_s", "0.01"},
                      {"a.watchdog_most_s", "0.4"}};
  EXPECT_EQ(keysSet(settings.devices), keysListed("devices"));
  const DeviceSettings read = processTables(settings).devices.at(0);
  EXPECT_EQ(read.kind, DeviceKind::ModbusRtu);
  EXPECT_EQ(read.address, "/dev/ttyS1");
  EXPECT_EQ(read.baud, 9600);
  EXPECT_EQ(read.parity, Parity::Odd);
  EXPECT_EQ(read.unit, 7);
  EXPECT_EQ(read.timeout_s, 0.3);
  EXPECT_EQ(read.retry_s, 2.5);
  EXPECT_EQ(read.answer, "ok");
  EXPECT_EQ(read.watchdog_register, 64);
  EXPECT_EQ(read.watchdog_unit_s, 0.01);
  EXPECT_EQ(read.watchdog_most_s, 0.4);
}

TEST(ProcessTables, EveryKeyOfAChannelIsRead) {
  ProcessTableSettings settings;
  settings.devices = {{"plc.kind", "none"}};
  settings.channels = {{"a.quantity", "screw_rpm"},
                       {"a.device", "plc"},
                       {"a.write", "3"},
                       {"a.scale", "2"},
                       {"a.offset", "1"},
                       {"a.low", "5"},
                       {"a.high", "90"},
                       {"a.safe", "4"},
                       {"a.nominal", "50"},
                       {"a.slew_per_s", "30"},
                       {"a.dead_time_s", "0.1"},
                       {"a.lag_s", "0.2"},
                       {"a.wire_diameter_mm", "1.2"},
                       {"a.screw", "10,100,60,90"},
                       {"a.fault_register", "80"}};
  EXPECT_EQ(keysSet(settings.channels), keysListed("channels"));
  const OutputChannel read = processTables(settings).channels.at(0);
  EXPECT_EQ(read.quantity, ProcessQuantity::ScrewSpeed);
  EXPECT_EQ(read.device, "plc");
  EXPECT_EQ(read.write, "3");
  EXPECT_EQ((std::vector<double>{read.scale, read.offset, read.low, read.high, read.safe, read.nominal}),
            (std::vector<double>{2.0, 1.0, 5.0, 90.0, 4.0, 50.0}));
  EXPECT_EQ((std::vector<double>{read.slew_per_s, read.dead_time_s, read.lag_s, read.wire_diameter_mm}),
            (std::vector<double>{30.0, 0.1, 0.2, 1.2}));
  EXPECT_EQ(read.screw, (std::vector<double>{10.0, 100.0, 60.0, 90.0}));
  EXPECT_EQ(read.fault_register, 80);
}

TEST(ProcessTables, EveryKeyOfAnInputIsRead) {
  ProcessTableSettings settings;
  settings.devices = {{"plc.kind", "none"}};
  settings.channels = {{"screw.quantity", "screw_rpm"}, {"screw.device", "plc"}, {"screw.high", "90"}};
  settings.inputs = {{"a.device", "plc"},    {"a.read", "7"},      {"a.signed", "true"},
                     {"a.scale", "0.5"},     {"a.offset", "-1"},   {"a.check", "present"},
                     {"a.channel", "screw"}, {"a.tolerance", "3"}, {"a.least", "2"},
                     {"a.after_s", "0.7"}};
  EXPECT_EQ(keysSet(settings.inputs), keysListed("inputs"));
  const InputChannel read = processTables(settings).inputs.at(0);
  EXPECT_EQ(read.device, "plc");
  EXPECT_EQ(read.read, 7);
  EXPECT_TRUE(read.is_signed);
  EXPECT_EQ(read.check, InputCheck::Present);
  EXPECT_EQ(read.channel, "screw");
  EXPECT_EQ((std::vector<double>{read.scale, read.offset, read.tolerance, read.least, read.after_s}),
            (std::vector<double>{0.5, -1.0, 3.0, 2.0, 0.7}));
}

TEST(ProcessTables, RefusalsNameRowKeyValueAndBound) {
  const auto laser = [](const std::string& rest) {
    return refusal(tables("{quantity: laser_power_w, device: coupler, low: 200, high: 4000" + rest + "}"));
  };
  EXPECT_EQ(laser(""), "accepted");
  EXPECT_EQ(laser(", power: 3"), "channels.laser: unknown setting 'power'");
  EXPECT_EQ(laser(", scale: 0"), "channels.laser: scale is 0; must be another number");
  EXPECT_EQ(laser(", safe: 5000"), "channels.laser: safe is 5000; must be at most high, 4000");
  EXPECT_EQ(laser(", nominal: 100"), "channels.laser: nominal is 100; must be 0 or in [200, 4000]");
  EXPECT_EQ(laser(", dead_time_s: -1"), "channels.laser: dead_time_s is '-1'; must be a number in [0, 10]");
  EXPECT_EQ(laser(", screw: \"1,2,3\""),
            "channels.laser: screw has 3 numbers; must be pairs of rpm and mm3 per revolution");
  EXPECT_EQ(refusal(tables("{quantity: laser_power_w, device: plc, high: 1}")),
            "channels.laser: device is 'plc'; must be one of devices");
  EXPECT_EQ(refusal(tables("{quantity: laser_power_w, device: coupler}")),
            "channels.laser: high is 0; must be above low, 0");
  EXPECT_EQ(refusal(tables(kLaser, "{device: coupler, check: follows, channel: beam}")),
            "inputs.seen: channel is 'beam'; must be one of channels");
  EXPECT_EQ(refusal(tables(kLaser, "{device: coupler, scale: 0}")),
            "inputs.seen: scale is 0; must be another number");
  EXPECT_EQ(refusal(tables("7")), "channels.laser is '7'; must be a map of rows by their names");
}

TEST(ProcessTables, AScrewThatFallsIsRefused) {
  EXPECT_EQ(refusal(tables("{quantity: screw_rpm, device: coupler, high: 60, screw: \"30,100,60,40\"}")),
            "channels.laser: screw has 40 mm3/s at 60 rpm behind 50 mm3/s at 30 "
            "rpm; both must rise");
}

TEST(ProcessTables, ScrewSpeedsGiveTheFlow) {
  const std::vector<double> screw = {10.0, 120.0, 60.0, 90.0};  // 20 and 90 mm3/s
  EXPECT_EQ(screwSpeed(0.0, screw), 0.0);
  EXPECT_NEAR(screwSpeed(10.0, screw), 5.0, 1e-9);  // 120 mm3 per revolution
  EXPECT_NEAR(screwSpeed(20.0, screw), 10.0, 1e-9);
  EXPECT_NEAR(screwSpeed(90.0, screw), 60.0, 1e-9);
  EXPECT_NEAR(screwSpeed(180.0, screw), 120.0, 1e-9);  // 90 mm3 per revolution
  // 35 rpm: halfway, 105 mm3 per revolution
  EXPECT_NEAR(screwSpeed(35.0 * 105.0 / 60.0, screw), 35.0, 1e-9);
}

TEST(ProcessTables, WhateverStandsInThemIsUsableOrRefused) {
  ASSERT_TRUE(rc::check("tables", [] {
    const auto word = rc::gen::element<std::string>(
        "laser", "screw", "quantity", "device", "write", "scale", "low", "high", "safe", "nominal", "screw",
        "check", "channel", "read", "kind", "address", "modbus_tcp", "laser_power_w", "0", "1", "-3", "2000",
        "10,100,20,90", "nan", "1e999", "follows", "", ".", "a.b");
    ProcessTableSettings settings;
    settings.devices = {{"coupler.kind", "modbus_tcp"}, {"coupler.address", "plc:502"}};
    for (SettingTable* const table : {&settings.channels, &settings.inputs}) {
      const int entries = *rc::gen::inRange(0, 8);
      for (int i = 0; i < entries; ++i) (*table)[*word + "." + *word] = *word;
      if (*rc::gen::arbitrary<bool>()) (*table)["laser.device"] = "coupler";
      if (*rc::gen::arbitrary<bool>()) (*table)["laser.high"] = "2000";
    }
    try {
      for (const OutputChannel& channel : processTables(settings).channels) {
        RC_ASSERT(channel.high > channel.low);
        RC_ASSERT(channel.safe <= channel.high);
        RC_ASSERT(channel.scale != 0.0);
        RC_ASSERT(channel.device == "coupler");
      }
    } catch (const InvalidConfig&) {
      // as it should
    }
  }));
}

}  // namespace
}  // namespace lamina
