// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "correction_messages.hpp"
#include "estimated_bag.hpp"
#include "ros/loop/wall_messages.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// Node and `lamina estimate` give the same maps over a print with a map that the machine missed.
TEST(MissedMapInABag, IsTakenIntoAccount) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.length_mm = 20.0;
  wall.layers = 4;
  wall.misses_map = [](std::size_t layer) { return layer == 2; };
  const test::ScratchFolder folder;
  const std::string bag = folder.file("wall.bag");
  const test::SensedWall printed = test::sensedWall(wall);
  test::writeBag(bag, printed);
  const std::vector<std::string> unreported = test::estimate(bag)["prints"][0]["map_digests"];
  const auto begun = std::find_if(printed.tips.begin(), printed.tips.end(),
                                  [](const StampedTip& pose) { return pose.tip.z() > 4.5 - 1e-6; });
  ASSERT_NE(begun, printed.tips.end()) << "layer 2 ends at 4.5 mm";
  {
    rosbag::Bag more(bag, rosbag::bagmode::Append);
    more.write(std::string("/") + names::kAppliedCorrection, test::timeOf(begun->stamp_ns),
               toMessage({2, 2.0, {}, {}}, printed.part.toolpath_id, ""));
  }
  const nlohmann::json reported = test::estimate(bag)["prints"][0];
  const auto& alarms = reported["layers"][2]["alarms"];
  EXPECT_EQ(std::count(alarms.begin(), alarms.end(), 6116), 1);
  EXPECT_EQ(reported["layers"][2]["state"], "coasting");
  const test::WallTruth truth = test::wallTruth(wall);
  EXPECT_NEAR(reported["layers"][2]["gain_mean"], truth.gain[2], 0.01) << "of what was deposited";
  const std::vector<std::string> expected = reported["map_digests"];
  EXPECT_NE(expected[3], unreported[3]);
  EXPECT_EQ(test::replayed(bag, wall.layers, "4"), expected);
}

std::size_t alarmsOf(const nlohmann::json& layer, int alarm) {
  return static_cast<std::size_t>(std::count(layer["alarms"].begin(), layer["alarms"].end(), alarm));
}

/// As the node does: a plan that the machine did not go on with, and a further map that it did not use.
TEST(MissedMapInABag, ReportsAPlanThatWasRefused) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.length_mm = 20.0;
  wall.layers = 8;
  const test::ScratchFolder folder;
  const std::string bag = folder.file("wall.bag");
  const test::SensedWall printed = test::sensedWall(wall);
  test::writeBag(bag, printed);
  const std::string replans = "--set loop.replan=scale --set loop.greatest_amount=0.05";
  const nlohmann::json unreported = test::estimate(bag, replans)["prints"][0];
  ASSERT_FALSE(unreported["plans"].empty()) << "growth of 0.9 needs amounts of a ninth";
  const std::string plan_id = unreported["plans"][0]["toolpath_id"];
  const std::size_t layer = unreported["plans"][0]["layer"];
  const double top_mm = printed.part.toolpath.layers[layer].z_mm;
  const auto amid = std::find_if(printed.tips.begin(), printed.tips.end(), [top_mm](const StampedTip& pose) {
    return std::abs(pose.tip.z() - top_mm) < 1e-6 && pose.tip.x() > 10.0;
  });
  ASSERT_NE(amid, printed.tips.end());
  {
    rosbag::Bag more(bag, rosbag::bagmode::Append);
    const std::string topic = std::string("/") + names::kAppliedCorrection;
    const ros::Time stamp = test::timeOf(amid->stamp_ns);
    more.write(topic, stamp, toMessage(refusedPlan("it is out of reach"), plan_id, ""));
    more.write(topic, stamp, toMessage({layer, 0.0, "it is late", {}}, printed.part.toolpath_id, "digest"));
  }
  const nlohmann::json reported = test::estimate(bag, replans)["prints"][0];
  EXPECT_EQ(alarmsOf(reported["layers"][layer], 6113), alarmsOf(unreported["layers"][layer], 6113) + 1);
  EXPECT_EQ(alarmsOf(reported["layers"][layer], 6116), 1U);
  EXPECT_EQ(reported["trims_refused"], 1);
  const std::vector<std::string> maps = reported["map_digests"];
  EXPECT_EQ(maps.size(), unreported["map_digests"].size() + 1) << "the layer has its map once more";
}

/// Of a second sensor whose time offset nobody stated: its clouds are named among those not read.
TEST(EstimatedBag, AccountsForEveryCloud) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.length_mm = 20.0;
  wall.layers = 3;
  const test::ScratchFolder folder;
  const std::string bag = folder.file("wall.bag");
  const test::SensedWall printed = test::sensedWall(wall);
  test::writeBag(bag, printed);
  {
    rosbag::Bag more(bag, rosbag::bagmode::Append);
    for (const SensedCloud& cloud : printed.clouds) {
      sensor_msgs::PointCloud2 left = test::cloudMessage(cloud);
      left.header.frame_id = "left";
      more.write(std::string("/") + names::kProfile, test::timeOf(cloud.stamp_ns + 1'000'000), left);
    }
  }
  const nlohmann::json print = test::estimate(bag)["prints"][0];
  EXPECT_EQ(print["clouds"], 2 * printed.clouds.size());
  EXPECT_EQ(print["clouds_without_offset"], printed.clouds.size());
  std::size_t sum = 0;
  for (const char* became : {"clouds_read", "clouds_late", "clouds_stuck", "clouds_without_frame",
                             "clouds_without_offset", "clouds_malformed", "clouds_without_transform",
                             "clouds_waiting", "clouds_pushed_out", "clouds_of_former_print"})
    sum += print[became].get<std::size_t>();
  EXPECT_EQ(sum, 2 * printed.clouds.size());
  const std::size_t read = print["points"]["received"];
  std::size_t accounted = 0;
  for (const auto& became : print["points"].items()) accounted += became.value().get<std::size_t>();
  EXPECT_EQ(accounted, 2 * read) << "all that was received, and what became of it";
  std::size_t sent = 0;
  for (const SensedCloud& cloud : printed.clouds) sent += cloud.profiles.at(0).size();
  EXPECT_EQ(read, sent) << "of the sensor that has its time offset";
  EXPECT_EQ(print["readings_below"], printed.counts.readings_below);
  EXPECT_EQ(print["readings_believed"], printed.counts.readings_believed);
}

}  // namespace
}  // namespace lamina
