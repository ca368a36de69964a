// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/process_schedule.hpp"

#include <gtest/gtest.h>

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

TimedPath timedWith(const ProcessSettings& process) {
  const Toolpath toolpath = beadTravelBead();
  const TiltingGantry gantry;
  TimingSettings settings;
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

}  // namespace
}  // namespace lamina
