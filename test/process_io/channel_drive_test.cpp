// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/channel_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/process_io/devices/lagging_response.hpp"

namespace lamina {
namespace {

constexpr double kDriveCycle = 0.01;  // s

OutputChannel laser() {
  OutputChannel channel;
  channel.name = "laser";
  channel.quantity = ProcessQuantity::LaserPower;
  channel.low = 200.0;
  channel.high = 2000.0;
  return channel;
}

ProcessSignals lit(double power_w) {
  ProcessSignals signals;
  signals.is_laser_on = true;
  signals.levels[ProcessLevel::LaserPower] = power_w;
  return signals;
}

ProcessPlan planOf(const std::vector<PlannedProcess>& points) {
  ProcessPlan plan;
  plan.accept({points, points.back().time_s});
  return plan;
}

TEST(ChannelDrive, AsksByGateLevelFlowAndNominalValue) {
  OutputChannel channel = laser();
  channel.safe = 7.0;
  channel.nominal = 500.0;
  ProcessSignals signals = lit(900.0);
  EXPECT_EQ(askedOf(channel, signals).value, 900.0);
  signals.levels = {};
  EXPECT_EQ(askedOf(channel, signals).value, 500.0);
  signals.is_laser_on = false;
  EXPECT_EQ(askedOf(channel, signals).value, 7.0);
  EXPECT_FALSE(askedOf(channel, signals).is_on);

  channel.quantity = ProcessQuantity::WireSpeed;
  channel.wire_diameter_mm = 2.0;
  signals.is_wire_fed = true;
  signals.flow_mm3_s = 10.0 * M_PI;
  EXPECT_NEAR(askedOf(channel, signals).value, 10.0, 1e-12);
  channel.wire_diameter_mm = 0.0;
  EXPECT_EQ(askedOf(channel, signals).value, 500.0);

  channel.quantity = ProcessQuantity::ScrewSpeed;
  channel.screw = {10.0, 120.0};
  signals.flow_mm3_s = 20.0;
  EXPECT_NEAR(askedOf(channel, signals).value, 10.0, 1e-12);
  signals.flow_mm3_s = 0.0;
  EXPECT_FALSE(askedOf(channel, signals).is_on);
}

TEST(ChannelDrive, SwitchesAndCarriersGoByTheirGates) {
  ProcessSignals signals;
  signals.is_powder_on = true;
  signals.levels[ProcessLevel::Powder] = 12.0;
  signals.levels[ProcessLevel::Gas] = 15.0;
  signals.levels[ProcessLevel::Fan] = 0.4;
  signals.flow_mm3_s = 3.0;
  const auto asked = [&signals](ProcessQuantity quantity) {
    OutputChannel channel;
    channel.quantity = quantity;
    return askedOf(channel, signals).value;
  };
  EXPECT_EQ(asked(ProcessQuantity::PowderOn), 1.0);
  EXPECT_EQ(asked(ProcessQuantity::Powder), 12.0);
  EXPECT_EQ(asked(ProcessQuantity::GasOn), 0.0);
  EXPECT_EQ(asked(ProcessQuantity::Gas), 0.0);
  EXPECT_EQ(asked(ProcessQuantity::LaserOn), 0.0);
  EXPECT_EQ(asked(ProcessQuantity::WireOn), 0.0);
  EXPECT_EQ(asked(ProcessQuantity::Fan), 0.4);
  EXPECT_EQ(asked(ProcessQuantity::Flow), 3.0);
}

TEST(ChannelDrive, SendsWhatIsPlannedForWhenItTakesEffect) {
  OutputChannel channel = laser();
  channel.dead_time_s = 0.1;
  ChannelDrive drive(channel, kDriveCycle);
  const ProcessPlan plan = planOf({{1.0, lit(500.0)}, {2.0, lit(800.0)}, {3.0, lit(800.0)}});
  EXPECT_EQ(drive.step(plan, 0.89), 0.0);    // for 0.995
  EXPECT_EQ(drive.step(plan, 0.90), 500.0);  // for 1.005
  EXPECT_EQ(drive.step(plan, 1.89), 500.0);  // for 1.995
  EXPECT_EQ(drive.step(plan, 1.90), 800.0);  // for 2.005
  EXPECT_EQ(drive.step(plan, 2.89), 800.0);  // for 2.995
  EXPECT_EQ(drive.step(plan, 2.90), 0.0);    // nothing is known for 3.005
}

TEST(ChannelDrive, ExpectsTheEffectAfterDeadTimeAndLag) {
  OutputChannel channel = laser();
  channel.dead_time_s = 0.05;
  channel.lag_s = 0.1;
  ChannelDrive drive(channel, kDriveCycle);
  LaggingResponse device(0.05, 0.1);
  const ProcessPlan plan = planOf({{0.3, lit(500.0)}, {0.6, lit(1500.0)}, {1.0, lit(1500.0)}});
  for (int cycle = 0; cycle < 100; ++cycle) {
    const double now_s = kDriveCycle * cycle;
    device.send(drive.step(plan, now_s), now_s);
    EXPECT_NEAR(drive.expected(), device.effectAt(now_s), 1e-6) << now_s;
  }
}

TEST(ChannelDrive, ARampThatTheBandAllowsIsFollowedWithoutLag) {
  OutputChannel channel = laser();
  channel.lag_s = 0.1;
  ChannelDrive drive(channel, kDriveCycle);
  LaggingResponse device(0.0, 0.1);
  std::vector<PlannedProcess> points;
  for (int i = 0; i <= 300; ++i) points.push_back({0.01 * i, lit(500.0 + 2.0 * i)});
  const ProcessPlan plan = planOf(points);
  for (int cycle = 0; cycle < 290; ++cycle) {
    const double now_s = kDriveCycle * cycle;
    device.send(drive.step(plan, now_s), now_s);
    // Power holds from point to point: 2 W.
    if (cycle < 50) continue;
    EXPECT_NEAR(device.effectAt(now_s + 0.5 * kDriveCycle), 500.0 + 2.0 * cycle, 3.0) << cycle;
  }
}

TEST(ChannelDrive, KeepsTheSlewWithinTheBandAndIsOffAtOnce) {
  OutputChannel channel = laser();
  channel.slew_per_s = 10000.0;  // 100 W a cycle
  ChannelDrive drive(channel, kDriveCycle);
  const ProcessPlan plan = planOf({{0.0, lit(550.0)}, {1.0, {}}, {2.0, {}}});
  EXPECT_EQ(drive.step(plan, 0.00), 300.0);
  EXPECT_EQ(drive.step(plan, 0.01), 400.0);
  EXPECT_EQ(drive.step(plan, 0.02), 500.0);
  EXPECT_EQ(drive.step(plan, 0.03), 550.0);
  EXPECT_EQ(drive.step(plan, 1.00), 0.0);
}

TEST(ChannelDrive, LimitsToTheBandAndReportsWhatWasAsked) {
  ChannelDrive drive(laser(), kDriveCycle);
  const ProcessPlan plan = planOf({{0.0, lit(3000.0)}, {1.0, lit(50.0)}, {2.0, lit(50.0)}});
  EXPECT_EQ(drive.step(plan, 0.0), 2000.0);
  EXPECT_EQ(drive.asked(), 3000.0);
  EXPECT_EQ(drive.step(plan, 1.5), 200.0);
  EXPECT_EQ(drive.makeSafe(1.6), 0.0);
  EXPECT_FALSE(drive.isOn());
}

TEST(ChannelDrive, TellsWhatIsAskedBeyondTheBandWhileItSetsOutEarly) {
  OutputChannel channel = laser();
  channel.lag_s = 0.1;
  ChannelDrive drive(channel, kDriveCycle);
  const ProcessPlan plan = planOf({{0.0, lit(500.0)}, {1.0, lit(3000.0)}, {2.0, lit(3000.0)}});
  for (int cycle = 0; cycle < 90; ++cycle) drive.step(plan, kDriveCycle * cycle);
  EXPECT_EQ(drive.asked(), 500.0);
  // At full power it is half way up, to 1250 W, after ln 2 of the lag; the step is planned 0.05 s later.
  EXPECT_EQ(drive.step(plan, 0.95), 2000.0);
  EXPECT_EQ(drive.asked(), 3000.0);
}

}  // namespace
}  // namespace lamina
