// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/devices/emulated_coupler.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

ModbusRequest write(std::uint16_t address, std::vector<std::uint16_t> values) {
  ModbusRequest request;
  request.function = ModbusFunction::WriteMany;
  request.write_address = address;
  request.written = std::move(values);
  return request;
}

CouplerSettings settingsOf(double watchdog_s, double dead_time_s, double lag_s) {
  CouplerSettings settings;
  settings.watchdog_s = watchdog_s;
  settings.dead_time_s = dead_time_s;
  settings.lag_s = lag_s;
  return settings;
}

TEST(EmulatedCoupler, GoesToItsFaultValuesWhenItsWatchdogExpires) {
  EmulatedCoupler coupler(settingsOf(0.5, 0.0, 0.0));
  coupler.answer(write(kCouplerFaultValues + 1, {9}), 0.0);
  EXPECT_EQ(coupler.at(kCouplerState, 10.0), 0);
  coupler.answer(write(kCouplerOutputs, {100, 200}), 10.0);
  EXPECT_EQ(coupler.at(kCouplerState, 10.4), 1);
  coupler.answer(write(kCouplerOutputs, {100}), 10.4);
  EXPECT_EQ(coupler.at(kCouplerOutputs + 1, 10.89), 200);
  EXPECT_EQ(coupler.at(kCouplerOutputs, 11.0), 0);
  EXPECT_EQ(coupler.at(kCouplerOutputs + 1, 11.0), 9);
  EXPECT_EQ(coupler.at(kCouplerState, 11.0), 2);
  ASSERT_EQ(coupler.events().size(), 4U);
  EXPECT_EQ(coupler.events()[2].cause, CouplerEvent::Cause::Watchdog);
  EXPECT_NEAR(coupler.events()[2].time_s, 10.9, 1e-12);
  coupler.answer(write(kCouplerOutputs, {5}), 12.0);
  EXPECT_EQ(coupler.at(kCouplerState, 12.0), 1);
}

TEST(EmulatedCoupler, WithoutAWatchdogValuesStay) {
  EmulatedCoupler coupler(settingsOf(0.5, 0.0, 0.0));
  coupler.answer(write(kCouplerWatchdog, {0}), 0.0);
  coupler.answer(write(kCouplerOutputs, {100}), 0.0);
  EXPECT_EQ(coupler.at(kCouplerOutputs, 1000.0), 100);
}

TEST(EmulatedCoupler, EffectsComeAfterDeadTimeAndLag) {
  EmulatedCoupler coupler(settingsOf(0.0, 0.1, 0.2));
  coupler.answer(write(kCouplerOutputs + 3, {1000}), 1.0);
  EXPECT_EQ(coupler.at(kCouplerEffects + 3, 1.09), 0);
  EXPECT_EQ(coupler.at(kCouplerEffects + 3, 1.3), 632);  // a time constant later
  coupler.block(3);
  EXPECT_EQ(coupler.at(kCouplerEffects + 3, 2.0), 0);
}

TEST(EmulatedCoupler, RefusesWhatItDoesNotHave) {
  EmulatedCoupler coupler({});
  const auto refuses = [&coupler](const ModbusRequest& request) {
    return static_cast<unsigned char>(coupler.answer(request, 0.0)[7]) >= 0x80;
  };
  EXPECT_TRUE(refuses(write(kCouplerEffects, {1})));
  EXPECT_TRUE(refuses(write(15, {1, 2})));
  EXPECT_TRUE(refuses(write(95, {1, 2})));
  ModbusRequest read;
  read.read_address = 90;
  read.read_count = 6;
  EXPECT_FALSE(refuses(read));
  read.read_count = 7;
  EXPECT_TRUE(refuses(read));
  EXPECT_EQ(coupler.at(kCouplerReady, 0.0), 1);
  coupler.setReady(false);
  EXPECT_EQ(coupler.at(kCouplerReady, 0.0), 0);
}

}  // namespace
}  // namespace lamina
