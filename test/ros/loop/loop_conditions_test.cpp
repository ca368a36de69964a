// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Until when the conditions of the loop are reported to the unit.
#include <gtest/gtest.h>

#include <algorithm>

#include "ros/loop/controlled_wall.hpp"
#include "ros/wait_until.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using test::Controller;
using test::LiveWall;
using test::SensedWallCase;
using test::SensorDoes;
using test::waitUntil;

const std::vector<std::string> kSoonSilent = {"_loop/silence_s:=1.5", "_monitor/reorder_s:=0.2",
                                              "_arrival_hold_s:=0.1"};

/// Three layers, of which the second is scanned in silence, for longer than is borne.
SensedWallCase silentWall() {
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.length_mm = 20.0;
  wall.layers = 3;
  wall.scan_mm_s = 8.0;
  wall.sensor = [](std::size_t layer) { return layer == 1 ? SensorDoes::KeepSilent : SensorDoes::Measure; };
  return wall;
}

TEST(HeightController, ReportsItsConditionsAsGoneWhenThePrintIsCutOff) {
  Controller controller(kSoonSilent);
  LiveWall live(silentWall());
  test::ReportedMachine machine;
  machine.say(lamina_msgs::MachineState::EXECUTE, 1);
  live.say([&] { return controller.hasRaised(6101); });
  ASSERT_TRUE(controller.hasRaised(6101));
  EXPECT_FALSE(controller.hasEnded(6101));
  machine.say(lamina_msgs::MachineState::ABORTED, 1);
  EXPECT_TRUE(waitUntil([&] { return controller.hasEnded(6101); }));
}

/// Killed while the sensor is silent: the next node does not report that as gone before it has heard it.
TEST(HeightController, ReportsWhatStandsWhenItIsStartedAnew) {
  const test::ScratchFolder folder;
  std::vector<std::string> parameters = kSoonSilent;
  parameters.push_back("_memory_file:=" + folder.file("memory.yaml"));
  std::optional<Controller> controller(std::in_place, parameters);
  LiveWall live(silentWall());
  live.say([&] { return controller->hasRaised(6101) && controller->isIn(lamina_msgs::LoopState::COASTING); });
  ASSERT_TRUE(controller->hasRaised(6101));
  EXPECT_EQ(controller->end(SIGKILL), -1);
  controller.emplace(parameters);
  ASSERT_TRUE(waitUntil([&] { return controller->hasRaised(6101) && !controller->maps.empty(); }));
  const auto first = std::find_if(controller->alarms.begin(), controller->alarms.end(),
                                  [](const auto& alarm) { return alarm.id == 6101; });
  EXPECT_FALSE(first->is_gone) << "the first that is told of it";
  EXPECT_FALSE(controller->hasEnded(6101));
  live.waitUntilHeard();
  live.say([&] { return controller->hasEnded(6101); });
  EXPECT_TRUE(waitUntil([&] { return controller->hasEnded(6101); }));
}

}  // namespace
}  // namespace lamina
