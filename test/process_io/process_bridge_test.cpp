// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/process_bridge.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kCycle = 0.01;  // s
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

ProcessTables laserAndWire() {
  ProcessTables tables;
  DeviceSettings device;
  device.name = "laser_source";
  tables.devices.push_back(device);
  device.name = "feeder";
  tables.devices.push_back(device);
  OutputChannel laser;
  laser.name = "laser";
  laser.device = "laser_source";
  laser.low = 200.0;
  laser.high = 2000.0;
  OutputChannel wire;
  wire.name = "wire";
  wire.quantity = ProcessQuantity::WireSpeed;
  wire.device = "feeder";
  wire.high = 60.0;
  tables.channels = {laser, wire};
  InputChannel power;
  power.name = "power";
  power.device = "laser_source";
  power.check = InputCheck::Follows;
  power.channel = "laser";
  power.tolerance = 50.0;
  power.after_s = 0.1;
  InputChannel current = power;
  current.name = "current";
  current.device = "feeder";
  current.check = InputCheck::Present;
  current.channel = "wire";
  current.least = 0.2;
  InputChannel interlock = power;
  interlock.name = "interlock";
  interlock.check = InputCheck::Ready;
  tables.inputs = {power, current, interlock};
  return tables;
}

ProcessSignals laying(double power_w = 1000.0) {
  ProcessSignals signals;
  signals.flow_mm3_s = 10.0;
  signals.is_laser_on = signals.is_wire_fed = true;
  signals.levels[ProcessLevel::LaserPower] = power_w;
  signals.levels[ProcessLevel::WireSpeed] = 30.0;
  return signals;
}

/// A bridge in simulated time, with devices and a machine that are well.
class BridgeRun {
 public:
  explicit BridgeRun(const ProcessTables& tables = laserAndWire(), ProcessBridgeSettings settings = {})
      : bridge(tables, settings, 0.0) {
    view.devices.assign(2, {true, ""});
    view.measured = {kNaN, kNaN, kNaN};
    plan({}, 0.6);  // as in front of a bead
    run(60);        // armed
  }

  void plan(const ProcessSignals& signals, double duration_s) {
    bridge.accept({{{now_s, signals}, {now_s + duration_s, signals}}, now_s + duration_s}, now_s);
  }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      now_s += kCycle;
      if (is_moving) bridge.updatePositions({{"x", now_s}}, now_s);
      last = bridge.cycle(now_s, view);
      for (const ProcessAlarm& alarm : last.alarms) alarms.push_back(alarm);
    }
  }
  std::vector<int> ids() const {
    std::vector<int> all;
    for (const ProcessAlarm& alarm : alarms) all.push_back(alarm.is_gone ? -alarm.id : alarm.id);
    return all;
  }

  ProcessBridge bridge;
  CycleView view;
  BridgeCycle last;
  std::vector<ProcessAlarm> alarms;
  double now_s = 0.0;
  bool is_moving = true;
};

const std::vector<double> kLaying = {1000.0, 30.0};
const std::vector<double> kSafe = {0.0, 0.0};

TEST(ProcessBridge, SendsThePlanAndIsSafeOnceItEnds) {
  BridgeRun run;
  EXPECT_EQ(run.last.fault, "");
  EXPECT_EQ(run.last.values, kSafe);
  run.plan(laying(), 0.5);
  run.run(49);
  EXPECT_EQ(run.last.values, kLaying);
  run.run(2);
  EXPECT_EQ(run.last.values, kSafe);
  EXPECT_TRUE(run.alarms.empty());
}

TEST(ProcessBridge, ALostDeviceTripsAllUntilTheProcessIsOff) {
  BridgeRun run;
  run.plan(laying(), 5.0);
  run.run(5);
  EXPECT_EQ(run.last.values, kLaying);
  run.view.devices[1] = {false, "no answer"};
  run.run(1);
  EXPECT_EQ(run.last.values, kSafe);
  EXPECT_EQ(run.ids(), std::vector<int>{5102});
  EXPECT_EQ(run.last.fault, "feeder is not connected: no answer");
  run.view.devices[1] = {true, ""};
  run.run(100);
  EXPECT_EQ(run.last.values, kSafe);  // in mid bead
  EXPECT_NE(run.last.fault, "");
  EXPECT_EQ(run.ids(), (std::vector<int>{5102, -5102}));
  run.plan({}, 1.0);
  run.run(55);
  EXPECT_EQ(run.last.fault, "");
  run.plan(laying(), 1.0);
  run.run(1);
  EXPECT_EQ(run.last.values, kLaying);
}

TEST(ProcessBridge, BeginsNoBeadInItsMiddleWhenItIsStartedAnew) {
  ProcessBridge bridge(laserAndWire(), {}, 0.0);
  CycleView view;
  view.devices.assign(2, {true, ""});
  view.measured = {kNaN, kNaN, kNaN};
  std::uint16_t reported = 0;
  auto until = [&, cycles = 0](double time_s) mutable {
    BridgeCycle last;
    std::vector<double> greatest = kSafe;
    for (; cycles * kCycle < time_s; ++cycles) {
      bridge.updatePositions({{"x", cycles * kCycle}}, cycles * kCycle);
      last = bridge.cycle(cycles * kCycle, view);
      for (const ProcessAlarm& alarm : last.alarms) reported = alarm.id;
      for (std::size_t i = 0; i < greatest.size(); ++i) greatest[i] = std::max(greatest[i], last.values[i]);
    }
    return std::make_pair(greatest, last.fault);
  };
  until(0.1);
  bridge.accept({{{0.8, laying()}, {2.0, laying()}}, 2.0}, 0.1);
  bridge.accept({{{2.0, laying()}, {3.0, laying()}}, 3.0}, 0.9);
  const auto [in_bead, fault] = until(2.9);
  EXPECT_EQ(in_bead, kSafe);
  EXPECT_NE(fault.find("in the middle of a bead"), std::string::npos) << fault;
  EXPECT_EQ(reported, 5104);
  bridge.accept({{{3.0, {}}, {3.7, {}}, {3.701, laying()}, {5.0, laying()}}, 5.0}, 2.9);
  EXPECT_EQ(until(3.65).second, "");
  EXPECT_EQ(until(4.0).first, kLaying) << "the next bead from its start";
}

TEST(ProcessBridge, ChunksThatAreTimedAFewMillisecondsApartAreOfOneBead) {
  BridgeRun run;
  run.plan(laying(), 0.1);
  const double from_s = run.now_s + 0.1 + 0.02;
  run.bridge.accept({{{from_s, laying()}, {from_s + 1.0, laying()}}, from_s + 1.0}, run.now_s);
  run.run(50);
  EXPECT_EQ(run.last.values, kLaying);
  EXPECT_EQ(run.last.fault, "");
}

/// Cycles until the beam is taken back on a machine of three joints at rest, or 200.
int cyclesLit(const std::function<std::map<std::string, double>(int)>& report) {
  BridgeRun run;
  run.is_moving = false;
  run.plan(laying(), 5.0);
  int lit = 0;
  for (; lit < 200 && run.ids().empty(); ++lit) {
    run.bridge.updatePositions(report(lit), run.now_s);
    run.run(1);
  }
  return lit;
}

TEST(ProcessBridge, NoReportOfJointsAtRestPassesForMotion) {
  const double standstill_s = ProcessBridgeSettings().standstill_s;
  const int most = static_cast<int>(standstill_s / kCycle) + 5;
  EXPECT_LE(cyclesLit([](int) { return std::map<std::string, double>{{"a", 0.1}, {"b", 0.2}}; }), most);
  const auto by_turns = [](int i) {
    return i % 2 == 0 ? std::map<std::string, double>{{"a", 0.1}, {"b", 0.2}}
                      : std::map<std::string, double>{{"c", 0.5}};
  };
  EXPECT_LE(cyclesLit(by_turns), most) << "a robot and its positioner report by themselves";
  const auto unknown = [](int) { return std::map<std::string, double>{{"a", 0.1}, {"b", kNaN}}; };
  EXPECT_LE(cyclesLit(unknown), most) << "an encoder that knows no position";
  const auto one_moves = [&by_turns](int i) {
    auto joints = by_turns(i);
    if (i % 2 == 1) joints["c"] += 1e-4 * i;
    return joints;
  };
  EXPECT_EQ(cyclesLit(one_moves), 200) << "the positioner alone turns";
}

TEST(ProcessBridge, ADeviceThatWasNeverThereIsAnAlarmAfterAWait) {
  ProcessBridgeSettings settings;
  settings.connect_wait_s = 2.0;
  BridgeRun run(laserAndWire(), settings);
  run.alarms.clear();
  ProcessBridge bridge(laserAndWire(), settings, 0.0);
  CycleView view = run.view;
  view.devices[0] = {false, "cannot connect"};
  BridgeCycle cycle = bridge.cycle(1.9, view);
  EXPECT_TRUE(cycle.alarms.empty());
  EXPECT_EQ(cycle.fault, "laser_source is not connected: cannot connect");
  cycle = bridge.cycle(2.0, view);
  ASSERT_EQ(cycle.alarms.size(), 1U);
  EXPECT_EQ(cycle.alarms[0].id, 5102);
  EXPECT_EQ(cycle.alarms[0].source, "laser_source");
}

TEST(ProcessBridge, LatenessIsReportedOnceASecondAndTripsWhenItIsTooMuch) {
  BridgeRun run;
  run.view.late_s = 0.5;
  run.run(1);  // nothing is on
  EXPECT_TRUE(run.alarms.empty());
  run.view.late_s = 0.0;
  run.plan(laying(), 5.0);
  run.run(2);
  run.view.late_s = 0.02;
  run.run(150);
  EXPECT_EQ(run.ids(), (std::vector<int>{5103, 5103}));
  EXPECT_EQ(run.alarms[0].message, "an output is 20.0 ms late; expected at most 10.0 ms");
  EXPECT_EQ(run.last.values, kLaying);
  run.view.late_s = 0.06;
  run.run(1);
  EXPECT_EQ(run.alarms.back().id, 5104);
  EXPECT_EQ(run.alarms.back().value, 60.0);
  EXPECT_EQ(run.last.values, kSafe);
}

TEST(ProcessBridge, WhatIsLateIsASetting) {
  ProcessBridgeSettings settings;
  settings.late_s = 0.03;
  settings.too_late_s = 0.2;
  BridgeRun run(laserAndWire(), settings);
  run.plan(laying(), 5.0);
  run.run(2);
  run.view.late_s = 0.025;
  run.run(2);
  EXPECT_TRUE(run.alarms.empty());
  run.view.late_s = 0.19;
  run.run(2);
  EXPECT_EQ(run.ids(), std::vector<int>{5103});
  run.view.late_s = 0.21;
  run.run(1);
  EXPECT_EQ(run.ids(), (std::vector<int>{5103, 5104}));
}

TEST(ProcessBridge, ChunksThatComeLateAreOutputsThatAreLate) {
  ProcessTables tables = laserAndWire();
  tables.channels[0].dead_time_s = 0.3;
  BridgeRun run(tables);
  run.plan(laying(), 1.0);  // laser should have been sent 0.305 s ago
  run.run(1);
  EXPECT_EQ(run.bridge.lateChunks(), 1U);
  run.run(1);
  EXPECT_EQ(run.bridge.overtaken(), 0U);
  run.bridge.accept({{{run.now_s + 0.1, {}}, {run.now_s + 0.5, {}}}, run.now_s + 0.5}, run.now_s);
  EXPECT_EQ(run.bridge.overtaken(), 1U);
  EXPECT_EQ(run.bridge.lateChunks(), 1U);
}

TEST(ProcessBridge, ABeamWithoutMotionTrips) {
  BridgeRun run;
  run.plan(laying(), 5.0);
  run.run(100);
  EXPECT_TRUE(run.alarms.empty());
  run.is_moving = false;
  run.run(29);
  EXPECT_TRUE(run.alarms.empty());
  run.run(3);
  ASSERT_EQ(run.ids(), std::vector<int>{5105});
  EXPECT_EQ(run.last.values, kSafe);
  run.run(50);
  EXPECT_EQ(run.alarms.size(), 1U);
}

TEST(ProcessBridge, HowLongABeamMayStandIsASetting) {
  ProcessBridgeSettings settings;
  settings.standstill_s = 1.0;
  BridgeRun run(laserAndWire(), settings);
  run.is_moving = false;
  run.plan(laying(), 5.0);
  run.run(90);
  EXPECT_TRUE(run.alarms.empty());
  run.run(20);
  EXPECT_EQ(run.ids(), std::vector<int>{5105});
}

TEST(ProcessBridge, AMachineThatIsNotHeardOfDoesNotMove) {
  BridgeRun run;
  run.is_moving = false;
  run.plan(laying(), 5.0);
  run.run(40);
  EXPECT_EQ(run.ids(), std::vector<int>{5105});
}

TEST(ProcessBridge, WhatIsAskedBeyondTheBandIsLimitedAndAnAlarm) {
  BridgeRun run;
  run.plan(laying(2500.0), 5.0);
  run.run(1);
  EXPECT_EQ(run.last.values, (std::vector<double>{2000.0, 30.0}));
  EXPECT_EQ(run.ids(), std::vector<int>{5101});
  run.plan(laying(), 5.0);
  run.run(1);
  EXPECT_EQ(run.ids(), (std::vector<int>{5101, -5101}));
}

TEST(ProcessBridge, WhatIsAskedBeyondTheBandIsAnAlarmOfALaggingChannelFromItsFirstCycleOn) {
  ProcessTables tables = laserAndWire();
  tables.channels[0].lag_s = 0.2;
  tables.inputs.clear();
  BridgeRun run(tables);
  run.view.measured.clear();
  const double begin_s = run.now_s + 0.5;
  const ProcessSignals much = laying(2500.0);
  run.bridge.accept({{{run.now_s, {}}, {begin_s, much}, {begin_s + 1.0, much}}, begin_s + 1.0}, run.now_s);
  for (int i = 0; i < 60 && run.last.values[0] == 0.0; ++i) run.run(1);
  EXPECT_LT(run.now_s, begin_s - 0.1) << "it sets out early";
  EXPECT_EQ(run.ids(), std::vector<int>{5101});
}

TEST(ProcessBridge, InputsAreJudged) {
  BridgeRun run;
  run.plan(laying(), 60.0);
  run.view.measured = {1040.0, 0.5, 1.0};
  run.run(20);
  EXPECT_EQ(run.last.fault, "");
  run.view.measured = {900.0, 0.1, 0.0};
  run.run(9);
  EXPECT_TRUE(run.alarms.empty());
  run.run(3);
  EXPECT_EQ(run.ids(), (std::vector<int>{5101, 5106, 5102}));
  EXPECT_EQ(run.alarms[0].message, "power of laser_source is 900 (laser_power_w); expected 1000, within 50");
  EXPECT_EQ(run.alarms[1].message,
            "current of feeder is 0.1 while wire is at 30 (wire_speed_mm_s); expected at least 0.2");
  EXPECT_EQ(run.last.values, kLaying);  // the driver is commanded to hold
  EXPECT_NE(run.last.fault, "");
  run.view.measured = {1000.0, 0.5, 1.0};
  run.run(1);
  EXPECT_EQ(run.ids(), (std::vector<int>{5101, 5106, 5102, -5101, -5106, -5102}));
  EXPECT_EQ(run.last.fault, "");
}

TEST(ProcessBridge, RowsOfOneNameInSeveralTablesAreJudgedByThemselves) {
  ProcessTables tables = laserAndWire();
  tables.inputs[0].name = "laser";         // as its channel
  tables.inputs[2].name = "laser_source";  // as its device
  BridgeRun run(tables);
  run.plan(laying(), 60.0);
  run.view.measured = {900.0, 0.5, 0.0};
  run.run(100);
  EXPECT_EQ(run.ids(), (std::vector<int>{5101, 5102}));
  EXPECT_EQ(run.alarms[0].source, "laser");
  EXPECT_EQ(run.alarms[1].source, "laser_source");
  run.plan(laying(2500.0), 60.0);
  run.run(1);
  EXPECT_EQ(run.ids(), (std::vector<int>{5101, 5102, 5101})) << "the channel beside its input";
  run.view.measured = {2000.0, 0.5, 1.0};
  run.run(1);
  EXPECT_EQ(run.ids(), (std::vector<int>{5101, 5102, 5101, -5102})) << "the channel is still asked too much";
  run.plan(laying(), 60.0);
  run.view.measured = {1000.0, 0.5, 1.0};
  run.run(1);
  EXPECT_EQ(run.ids().back(), -5101);
}

TEST(ProcessBridge, NothingFlowsIsAnAlarmOfItsOwn) {
  ProcessTables tables = laserAndWire();
  tables.channels[1].quantity = ProcessQuantity::ScrewSpeed;
  BridgeRun run(tables);
  ProcessSignals signals = laying();
  signals.levels[ProcessLevel::ScrewSpeed] = 30.0;
  run.plan(signals, 5.0);
  run.view.measured = {1000.0, 0.0, 1.0};
  run.run(15);
  EXPECT_EQ(run.ids(), std::vector<int>{5107});
}

TEST(ProcessBridge, StopIsSafe) {
  BridgeRun run;
  run.plan(laying(), 5.0);
  run.run(2);
  EXPECT_EQ(run.bridge.stop(run.now_s), kSafe);
  run.run(1);
  EXPECT_EQ(run.last.values, kSafe);
}

/// Any chunk: also ones that overlap, lie in the past, are not valid, or hold numbers that are none.
ProcessChunk anyChunk(double now_s) {
  const auto number = [] {
    return *rc::gen::oneOf(rc::gen::map(rc::gen::inRange(0, 3000), [](int i) { return 1.0 * i; }),
                           rc::gen::element(kNaN, -1.0, 1e300, 0.0));
  };
  ProcessChunk chunk;
  double time_s = now_s + 0.001 * *rc::gen::inRange(-500, 1000);
  const int points = *rc::gen::inRange(0, 5);
  for (int i = 0; i < points; ++i) {
    ProcessSignals signals = laying(number());
    signals.flow_mm3_s = number();
    signals.is_laser_on = *rc::gen::arbitrary<bool>();
    signals.levels[ProcessLevel::WireSpeed] = number();
    chunk.points.push_back({*rc::gen::inRange(0, 50) == 0 ? kNaN : time_s, signals});
    time_s += 0.001 * *rc::gen::inRange(0, 300);
  }
  chunk.valid_until_s = time_s + 0.001 * *rc::gen::inRange(-300, 300);
  return chunk;
}

TEST(ProcessBridge, NeverLeavesBandsNorIsOnBeyondWhatIsKnown) {
  ASSERT_TRUE(rc::check("band and validity", [] {
    ProcessTables tables = laserAndWire();
    for (OutputChannel& channel : tables.channels) {
      channel.dead_time_s = 0.001 * *rc::gen::inRange(0, 500);
      channel.lag_s = 0.001 * *rc::gen::inRange(0, 300);
      channel.slew_per_s = *rc::gen::element(0.0, 100.0, 1e5);
      channel.nominal = *rc::gen::element(0.0, 50.0) * (channel.low > 0.0 ? 10.0 : 1.0);
    }
    BridgeRun run(tables);
    double valid_until_s = -1.0;
    for (int i = 0; i < 40; ++i) {
      const ProcessChunk chunk = anyChunk(run.now_s);
      try {
        run.bridge.accept(chunk, run.now_s);
        valid_until_s = chunk.valid_until_s;
      } catch (const InvalidInput&) {  // and nothing has changed
      }
      run.view.devices[0].is_connected = *rc::gen::inRange(0, 20) != 0;
      const int cycles = *rc::gen::inRange(1, 20);
      for (int c = 0; c < cycles; ++c) {
        run.run(1);
        for (std::size_t v = 0; v < 2; ++v) {
          const OutputChannel& channel = tables.channels[v];
          const double value = run.last.values[v];
          RC_ASSERT(value == channel.safe || (value >= channel.low && value <= channel.high));
          if (run.now_s + channel.dead_time_s > valid_until_s) RC_ASSERT(value == channel.safe);
          if (!run.view.devices[0].is_connected) RC_ASSERT(value == channel.safe);
        }
      }
    }
  }));
}

}  // namespace
}  // namespace lamina
