// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/process_schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/trajectory/timed_path.hpp"
#include "support/joint_paths.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::TiltingGantry;

/// A bead of 30 mm, a travel of 30 mm, a bead of 30 mm, at 30 mm/s and 500 mm/s² throughout: 1.06 s each.
Toolpath beadTravelBead() {
  Toolpath toolpath{"beads", {{0.2, 0.2, {}}}};
  for (int i = 0; i < 3; ++i)
    toolpath.layers[0].paths.push_back(test::straightPath({30.0 * i, 0, 0.2}, {30.0 * (i + 1), 0, 0.2}));
  toolpath.layers[0].paths[1].role = PathRole::Travel;
  toolpath.layers[0].paths[1].bead = Bead{};
  return toolpath;
}
constexpr double kEach = 1.06;

TimedPath timedWith(const ProcessSettings& process, const Toolpath& toolpath = beadTravelBead(),
                    double jerk_ramp_s = 0.0) {
  const TiltingGantry gantry;
  TimingSettings settings;
  settings.trajectory.jerk_ramp_s = jerk_ramp_s;
  settings.motion.acceleration_mm_s2 = settings.motion.travel_acceleration_mm_s2 = 500.0;
  settings.trajectory.joint_ramp_s = 1e-3;
  settings.process = process;
  return {toolpath, uprightPath(toolpath, gantry), gantry, settings};
}

void expectEvents(const TimedPath& timed, const std::vector<ProcessEvent>& expected) {
  ASSERT_EQ(timed.events().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(timed.events()[i].time_s, expected[i].time_s, 1e-9) << i;
    EXPECT_STREQ(toString(timed.events()[i].channel), toString(expected[i].channel)) << i;
    EXPECT_EQ(timed.events()[i].is_on, expected[i].is_on) << i;
  }
}

TEST(ProcessSchedule, AnExtruderSwitchesNothing) {
  const TimedPath timed = timedWith({});
  EXPECT_TRUE(timed.events().empty());
  const double area = crossSection({0.4, 0.2});
  EXPECT_EQ(timed.at(0.5).process, (ProcessSignals{30.0 * area, false, false, false, false}));
  EXPECT_EQ(timed.at(1.5).process, safeSignals());
}

TEST(ProcessSchedule, PowderAndGasRunOnceTheLaserPerBead) {
  ProcessSettings process;
  process.kind = ProcessKind::Powder;
  using C = ProcessChannel;
  expectEvents(timedWith(process), {{0, C::Laser, true},
                                    {0, C::Powder, true},
                                    {0, C::Gas, true},
                                    {kEach, C::Laser, false},
                                    {2 * kEach, C::Laser, true},
                                    {3 * kEach, C::Laser, false},
                                    {3 * kEach, C::Powder, false},
                                    {3 * kEach, C::Gas, false}});
  const TimedPath timed = timedWith(process);
  EXPECT_TRUE(timed.at(0.5).process.is_laser_on);
  EXPECT_FALSE(timed.at(1.5).process.is_laser_on);
  EXPECT_TRUE(timed.at(1.5).process.is_powder_on);
  EXPECT_FALSE(timed.at(1.5).process.is_wire_fed);
  EXPECT_EQ(timed.at(3 * kEach + 1e-6).process, safeSignals());
}

TEST(ProcessSchedule, LeadsAndWaitsShiftWhatIsSwitched) {
  ProcessSettings process;
  process.kind = ProcessKind::Wire;
  process.settling_s = 0.5;
  process.wait_before_s = 0.3;
  process.wait_after_s = 0.4;
  process.laser_on_lead_s = 0.2;
  process.wire_on_lead_s = -0.1;
  process.wire_off_lead_s = 0.25;
  using C = ProcessChannel;
  const double first = 0.8;
  const double second = first + kEach + 0.4 + kEach + 0.3;
  expectEvents(timedWith(process), {{0, C::Gas, true},
                                    {first - 0.2, C::Laser, true},
                                    {first + 0.1, C::Wire, true},
                                    {first + kEach - 0.25, C::Wire, false},
                                    {first + kEach, C::Laser, false},
                                    {second - 0.2, C::Laser, true},
                                    {second + 0.1, C::Wire, true},
                                    {second + kEach - 0.25, C::Wire, false},
                                    {second + kEach, C::Laser, false},
                                    {second + kEach + 0.4, C::Gas, false}});
}

TEST(ProcessSchedule, RefusesBeadsShorterThanTheirLeads) {
  ProcessSettings process;
  process.kind = ProcessKind::Powder;
  process.laser_on_lead_s = -0.6;
  process.laser_off_lead_s = 0.6;
  EXPECT_THROW(timedWith(process), InvalidInput);
}

TEST(ProcessSchedule, BeadsWhoseLeadsOverlapAreOne) {
  ProcessSettings process;
  process.kind = ProcessKind::Powder;
  process.laser_on_lead_s = 0.6;
  process.laser_off_lead_s = -0.6;
  const TimedPath timed = timedWith(process);
  EXPECT_EQ(timed.events().size(), 6U) << "laser, powder and gas, on and off once each";
}

/// The first bead at 900 W with 12 mm/s of wire and 15 l/min, the second at 700 W; a fan from the travel on.
Toolpath statedBeads() {
  Toolpath toolpath = beadTravelBead();
  std::vector<Path>& paths = toolpath.layers[0].paths;
  paths[0].values = {{"laser_power_w", 900.0}, {"wire_speed_mm_s", 12.0}, {"gas_l_min", 15.0}};
  paths[1].events = {{0, FanShare{0.4}}};
  paths[2].values = {{"laser_power_w", 700.0}, {"screw_rpm", 30.0}};
  return toolpath;
}

TEST(ProcessSchedule, LevelsGoWithMotionAndSwitches) {
  ProcessSettings process;
  process.kind = ProcessKind::Wire;
  const TimedPath timed = timedWith(process, statedBeads());
  const auto levels = [&timed](double time_s) { return timed.at(time_s).process.levels; };
  using Level = ProcessLevel;
  EXPECT_EQ(levels(0.5)[Level::LaserPower], 900.0);
  EXPECT_NEAR(levels(0.5)[Level::WireSpeed], 12.0, 1e-9);
  EXPECT_NEAR(levels(0.03)[Level::WireSpeed], 6.0, 1e-9);  // half the speed: 500 mm/s2 for 0.03 s
  EXPECT_EQ(levels(0.03)[Level::LaserPower], 900.0);
  EXPECT_EQ(levels(0.5)[Level::Gas], 15.0);
  EXPECT_FALSE(levels(0.5).has(Level::ScrewSpeed) || levels(0.5).has(Level::Fan));
  EXPECT_FALSE(levels(kEach + 0.5).has(Level::LaserPower));
  EXPECT_EQ(levels(kEach + 0.5)[Level::Fan], 0.4);
  EXPECT_EQ(levels(2.0 * kEach + 0.5)[Level::LaserPower], 700.0);
  EXPECT_NEAR(levels(2.0 * kEach + 0.5)[Level::ScrewSpeed], 30.0, 1e-9);
  EXPECT_EQ(levels(2.0 * kEach + 0.5)[Level::Fan], 0.4);
}

TEST(ProcessSchedule, LevelsThatAreSwitchedOffAreNone) {
  ProcessSettings process;
  process.kind = ProcessKind::Powder;  // without wire
  process.laser_on_lead_s = -0.2;
  const TimedPath timed = timedWith(process, statedBeads());
  EXPECT_EQ(timed.at(0.1).process.levels[ProcessLevel::LaserPower], 0.0);
  EXPECT_EQ(timed.at(0.3).process.levels[ProcessLevel::LaserPower], 900.0);
  EXPECT_EQ(timed.at(0.3).process.levels[ProcessLevel::WireSpeed], 0.0);
}

TEST(ProcessSchedule, MaterialPerLengthStaysWhereJerkIsLimited) {
  ProcessSettings process;
  process.kind = ProcessKind::Wire;
  const TimedPath timed = timedWith(process, statedBeads(), 0.05);
  double wire_mm = 0.0;
  constexpr double kSum = 1e-4;
  for (double time_s = 0.5 * kSum; time_s < timed.duration(); time_s += kSum) {
    const double speed = timed.at(time_s).process.levels[ProcessLevel::WireSpeed];
    wire_mm += std::isnan(speed) ? 0.0 : kSum * speed;
  }
  EXPECT_NEAR(wire_mm, 12.0, 1e-3);  // 12 mm/s at 30 mm/s along 30 mm
}

}  // namespace
}  // namespace lamina
