// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a print teaches the next one, and which end of a job is that of the print.
#include <gtest/gtest.h>

#include <filesystem>

#include "correction_messages.hpp"
#include "latched.hpp"
#include "ros/bag_player.hpp"
#include "ros/loop/controlled_wall.hpp"
#include "ros/loop/wall_messages.hpp"
#include "ros/wait_until.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using test::Controller;
using test::LiveWall;
using test::ReportedMachine;
using test::SensedWall;
using test::sensedWall;
using test::SensedWallCase;
using test::waitUntil;

SensedWallCase wallOfThreeLayers() {
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.length_mm = 20.0;
  wall.layers = 3;
  return wall;
}

/// A part that grows by nine tenths teaches the next one 1 / 0.9 - 1, from its first layer on; one that was
/// not complete teaches nothing.
TEST(HeightController, TeachesTheNextPart) {
  const test::ScratchFolder folder;
  const SensedWallCase wall = wallOfThreeLayers();
  const SensedWall printed = sensedWall(wall);
  test::writeBag(folder.file("wall.bag"), printed);
  const std::string file = folder.file("report/learnt_part.csv");
  const std::string material = "_process/material:=steel";
  {
    Controller first({material, "_output_folder:=" + folder.file("report")});
    const test::BagPlayer player(folder.file("wall.bag"), {"--rate=10"});
    ASSERT_TRUE(waitUntil([&] { return first.layers.size() >= wall.layers; }));
    ReportedMachine machine;
    machine.say(lamina_msgs::MachineState::EXECUTE, 2);
    machine.say(lamina_msgs::MachineState::STOPPED, 2);
    ros::WallDuration(0.5).sleep();
    EXPECT_FALSE(std::filesystem::exists(file));
    machine.say(lamina_msgs::MachineState::COMPLETE, 2);
    ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(file); }));
  }
  Controller next({material, "_loop/learned:=" + file});
  ros::NodeHandle node;
  auto toolpath = node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  publishLatched(toolpath, test::toolpathMessage(printed));
  ASSERT_TRUE(waitUntil([&] { return !next.maps.empty(); }));
  const CorrectionMap map = toCore(next.maps.front());
  EXPECT_EQ(map.layer, 0U);
  ASSERT_EQ(map.paths.size(), 1U);
  EXPECT_NEAR(correctionAt(map.paths[0], 10.0).amount, 1.0 / 0.9 - 1.0, 0.01);
}

/// The end of the print before, which an executor repeats, is none of the print that has begun.
TEST(HeightController, LearnsFromAPrintThatBeginsWithTheEndOfTheOneBefore) {
  const test::ScratchFolder folder;
  const SensedWallCase wall = wallOfThreeLayers();
  test::writeBag(folder.file("wall.bag"), sensedWall(wall));
  const std::string file = folder.file("report/learnt_part.csv");
  Controller controller({"_process/material:=steel", "_output_folder:=" + folder.file("report")});
  ReportedMachine machine;
  const test::BagPlayer player(folder.file("wall.bag"), {"--rate=10"});
  ASSERT_TRUE(waitUntil([&] { return !controller.maps.empty(); }));
  machine.say(lamina_msgs::MachineState::COMPLETE, 2);
  ASSERT_TRUE(waitUntil([&] { return controller.layers.size() >= wall.layers; }));
  EXPECT_FALSE(std::filesystem::exists(file));
  machine.say(lamina_msgs::MachineState::EXECUTE, 2);
  machine.say(lamina_msgs::MachineState::COMPLETE, 2);
  EXPECT_TRUE(waitUntil([&] { return std::filesystem::exists(file); }));
}

/// The machine says that the job is complete ahead of what was seen of its last layer.
TEST(HeightController, MeasuresTheLastLayerByWhatArrivesAfterTheEnd) {
  constexpr double kIntoTheScan = 1.25;  // s: a bead of 20 mm at 20 mm/s, and the lift after it
  Controller controller;
  LiveWall live(wallOfThreeLayers());
  ReportedMachine machine;
  machine.say(lamina_msgs::MachineState::EXECUTE, 0);
  live.say([&] { return controller.layers.size() == 2; });
  ASSERT_EQ(controller.layers.size(), 2U);
  const ros::Time at_last = live.now();
  live.say([&] { return live.now() - at_last > ros::Duration(kIntoTheScan - 0.5); });  // stamps wait as long
  machine.say(lamina_msgs::MachineState::COMPLETE, 2);
  live.say([] { return false; });
  ASSERT_TRUE(waitUntil([&] { return controller.layers.size() == 3; }));
  EXPECT_GT(controller.layers.back().coverage, 0.95);
}

/// A toolpath is driven once more without being announced again.
TEST(HeightController, BeginsTheNextPartOfTheSameToolpath) {
  Controller controller;
  LiveWall live(wallOfThreeLayers());
  ReportedMachine machine;
  machine.say(lamina_msgs::MachineState::EXECUTE, 0);
  live.say([&] { return controller.layers.size() >= 3; });
  ASSERT_TRUE(waitUntil([&] { return controller.layers.size() == 3 && controller.maps.size() == 3; }));
  machine.say(lamina_msgs::MachineState::COMPLETE, 2);
  machine.say(lamina_msgs::MachineState::COMPLETE, 2);
  machine.say(lamina_msgs::MachineState::STARTING, -1);
  machine.say(lamina_msgs::MachineState::EXECUTE, 0);
  ASSERT_TRUE(waitUntil([&] { return controller.maps.size() > 3; }));
  EXPECT_EQ(controller.maps.back().layer, 0U);
  EXPECT_TRUE(controller.maps.back().paths.empty()) << "nothing is known of the first layer";
  ASSERT_TRUE(waitUntil([&] { return controller.states.back().layer == 0; }));
  EXPECT_EQ(controller.states.back().state, lamina_msgs::LoopState::ACTIVE + 0);
}

/// A job that was cut off at its third layer is gone on with there; then the part is begun anew.
TEST(HeightController, TellsAJobThatGoesOnFromTheNextPart) {
  SensedWallCase wall = wallOfThreeLayers();
  wall.layers = 4;
  Controller controller;
  LiveWall live(wall);
  ReportedMachine machine;
  machine.say(lamina_msgs::MachineState::EXECUTE, 0);
  live.say([&] { return controller.layers.size() >= 2 && controller.states.back().layer == 2; });
  ASSERT_TRUE(waitUntil([&] { return controller.maps.size() == 3; }));
  machine.say(lamina_msgs::MachineState::STOPPED, 2);
  machine.say(lamina_msgs::MachineState::STARTING, -1);
  machine.say(lamina_msgs::MachineState::EXECUTE, 2);
  live.say([&] { return controller.maps.size() >= 4; });
  ASSERT_TRUE(waitUntil([&] { return controller.maps.size() == 4; }));
  EXPECT_EQ(controller.maps.back().layer, 3U) << "it goes on";
  machine.say(lamina_msgs::MachineState::STOPPED, 3);
  machine.say(lamina_msgs::MachineState::EXECUTE, 0);
  ASSERT_TRUE(waitUntil([&] { return controller.maps.size() > 4; }));
  EXPECT_EQ(controller.maps.back().layer, 0U);
}

}  // namespace
}  // namespace lamina
