// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Toolpaths that are delivered once more amid their print, as ROS does where a connection was made again, and
// plans with which a loop begins.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <set>

#include "ros/bag_player.hpp"
#include "ros/loop/controlled_wall.hpp"
#include "ros/loop/shown_cells.hpp"
#include "ros/loop/wall_messages.hpp"
#include "ros/wait_until.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

std::size_t firstLayers(const test::Controller& controller) {
  return static_cast<std::size_t>(std::count_if(controller.maps.begin(), controller.maps.end(),
                                                [](const auto& map) { return map.layer == 0; }));
}

TEST(HeightController, GoesOnWhenItsToolpathIsDeliveredAgain) {
  const test::ScratchFolder folder;
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.length_mm = 20.0;
  wall.layers = 5;
  test::Controller controller({"_memory_file:=" + folder.file("memory.yaml")});
  test::LiveWall live(wall);
  // What is kept of a layer is written after its figures were published, and before the next state is.
  live.say([&] { return controller.layers.size() >= 3 && controller.states.back().layer == 3; });
  ASSERT_TRUE(std::filesystem::exists(folder.file("memory.yaml")));
  live.announce(live.toolpath);
  live.say([&] { return controller.layers.size() >= wall.layers; });
  ASSERT_TRUE(test::waitUntil([&] { return controller.layers.size() >= wall.layers; }))
      << controller.layers.size() << " layers";
  for (std::size_t k = 0; k < wall.layers; ++k) EXPECT_EQ(controller.layers[k].layer, k);
  EXPECT_EQ(firstLayers(controller), 1U);

  lamina_msgs::Toolpath next = live.toolpath;
  next.header.stamp += ros::Duration(60.0);
  live.announce(next);
  EXPECT_TRUE(test::waitUntil([&] { return firstLayers(controller) == 2; })) << "a new stamp is a new print";
}

TEST(HeightController, NumbersTheLayersOfAPlanThatItBeginsWith) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.length_mm = 20.0;
  wall.layers = 3;
  test::SensedWall sensed = test::sensedWall(wall);
  sensed.part.toolpath_id = "plan-from-5-of-parent";
  const test::ScratchFolder folder;
  test::writeBag(folder.file("wall.bag"), sensed);
  const test::Controller controller;
  const test::ShownCells shown{ros::NodeHandle()};
  const test::BagPlayer player(folder.file("wall.bag"), {"--rate=10"});
  ASSERT_TRUE(test::waitUntil([&] { return shown.areAll(wall.layers); }));
  EXPECT_EQ(shown.layers(), (std::set<std::int32_t>{5, 6, 7}));
}

}  // namespace
}  // namespace lamina
