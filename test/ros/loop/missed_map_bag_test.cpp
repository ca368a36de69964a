// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "correction_messages.hpp"
#include "estimated_bag.hpp"
#include "ros/wall_messages.hpp"
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
  const std::vector<std::string> untold = test::estimate(bag)["prints"][0]["map_digests"];
  const auto begun = std::find_if(printed.tips.begin(), printed.tips.end(),
                                  [](const StampedTip& pose) { return pose.tip.z() > 4.5 - 1e-6; });
  ASSERT_NE(begun, printed.tips.end()) << "layer 2 ends at 4.5 mm";
  {
    rosbag::Bag more(bag, rosbag::bagmode::Append);
    more.write(std::string("/") + names::kAppliedCorrection, test::timeOf(begun->stamp_ns),
               toMessage({2, 2.0, {}, {}}, printed.part.toolpath_id, ""));
  }
  const nlohmann::json told = test::estimate(bag)["prints"][0];
  const auto& alarms = told["layers"][2]["alarms"];
  EXPECT_EQ(std::count(alarms.begin(), alarms.end(), 6116), 1);
  EXPECT_EQ(told["layers"][2]["state"], "coasting");
  const test::WallTruth truth = test::wallTruth(wall);
  EXPECT_NEAR(told["layers"][2]["gain_mean"], truth.gain[2], 0.01) << "of what was laid";
  const std::vector<std::string> expected = told["map_digests"];
  EXPECT_NE(expected[3], untold[3]);
  EXPECT_EQ(test::replayed(bag, wall.layers, "4"), expected);
}

}  // namespace
}  // namespace lamina
