// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/remaining_motion.hpp"

#include <gtest/gtest.h>

#include <string>

#include "lamina/base/error.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

/// Two layers whose waypoints have one joint each, that counts them, and lines 10, 20, ...
StatedMotion countedMotion() {
  StatedMotion motion;
  motion.toolpath = test::twoLayers();
  motion.toolpath.layers[0].paths[0].feed_mm_s = AlongPath<double>(std::vector<double>{4, 1, 2, 3});
  motion.toolpath.layers[0].paths[0].events = {{0, Dwell{0.5}}, {3, Dwell{0.25}}};
  for (std::size_t l = 0; l < 2; ++l)
    for (std::size_t p = 0; p < motion.toolpath.layers[l].paths.size(); ++p) {
      const Path& path = motion.toolpath.layers[l].paths[p];
      for (std::size_t s = 0; s <= path.motionCount(); ++s) {
        motion.joints.at.push_back({l, p, s == 0 ? 0 : path.motionEnd(s - 1)});
        motion.joints.values.push_back(JointValues::Constant(1, static_cast<double>(motion.lines.size())));
        motion.lines.push_back(10 * (motion.lines.size() + 1));
      }
    }
  return motion;
}

TEST(RemainingMotion, OfALayerBeginsWithItsFirstPathThatDeposits) {
  const StatedMotion motion = countedMotion();  // 5 stations of the wall, 2 of the travel, 2 of the line
  ASSERT_EQ(motion.lines.size(), 9U);
  const StatedMotion rest = remainingMotion(motion, waypointOfLayer(motion, 1));
  ASSERT_EQ(rest.toolpath.layers.size(), 1U);
  EXPECT_EQ(rest.toolpath.layers[0].z_mm, 0.4);
  ASSERT_EQ(rest.joints.values.size(), 2U);
  EXPECT_EQ(rest.joints.values[0][0], 7.0);
  EXPECT_EQ(rest.joints.at[1], (WaypointIndex{0, 0, 1}));
  EXPECT_EQ(rest.lines, (std::vector<std::size_t>{80, 90}));
  EXPECT_EQ(waypointAtHeight(motion, 0.4), (WaypointIndex{1, 0, 0}));
  EXPECT_EQ(waypointAtHeight(motion, 0.05), (WaypointIndex{0, 0, 0}));
}

TEST(RemainingMotion, OfAClosedPathIsOpenAndReturnsToItsStart) {
  const StatedMotion motion = countedMotion();
  // Line 40 states waypoint 3, so that its move sets out from waypoint 2.
  EXPECT_EQ(waypointAtLine(motion, {40}), (WaypointIndex{0, 0, 2}));
  EXPECT_EQ(waypointAtLine(motion, {31}), (WaypointIndex{0, 0, 2}));
  const StatedMotion rest = remainingMotion(motion, {0, 0, 2});
  validate(rest.toolpath);
  const Path& path = rest.toolpath.layers.at(0).paths.at(0);
  EXPECT_FALSE(path.is_closed);
  ASSERT_EQ(path.points.size(), 3U);
  EXPECT_EQ(path.points[0], Point3(10, 10, 0.2));
  EXPECT_EQ(path.points[2], Point3(0, 0, 0.2));
  EXPECT_EQ(path.feed_mm_s.at(1), 3.0);
  EXPECT_EQ(path.feed_mm_s.at(2), 4.0);
  ASSERT_EQ(path.events.size(), 1U);
  EXPECT_EQ(path.events[0].motion, 1U);
  ASSERT_EQ(rest.joints.values.size(), 7U);
  EXPECT_EQ(rest.joints.values[0][0], 2.0);
  EXPECT_EQ(rest.joints.at[2], (WaypointIndex{0, 0, 2}));
  EXPECT_EQ(rest.joints.values[2][0], 4.0);
}

TEST(RemainingMotion, BeginsAnewWhereAPathDoes) {
  const StatedMotion motion = countedMotion();
  EXPECT_EQ(waypointAtLine(motion, {1}), (WaypointIndex{0, 0, 0}));
  EXPECT_EQ(waypointAtLine(motion, {80}), (WaypointIndex{1, 0, 0}));
  const StatedMotion whole = remainingMotion(motion, {0, 0, 0});
  EXPECT_EQ(toolpathId(whole.toolpath), toolpathId(motion.toolpath));
  EXPECT_EQ(whole.lines, motion.lines);
}

TEST(RemainingMotion, RefusesWhatIsNotThere) {
  StatedMotion motion = countedMotion();
  EXPECT_THROW(waypointOfLayer(motion, 2), InvalidInput);
  EXPECT_THROW(waypointAtHeight(motion, 0.5), InvalidInput);
  EXPECT_THROW(waypointAtLine(motion, {91}), InvalidInput);
  EXPECT_THROW(remainingMotion(motion, {1, 0, 1}), InvalidInput);
}

TEST(RemainingMotion, OfSeveralFilesGoesOnFromALineOfOneOfThem) {
  StatedMotion motion = countedMotion();
  // The travel and the second layer, from the end of the travel on, stand in another file.
  motion.lines = {10, 20, 30, 40, 50, 50, 12, 12, 22};
  motion.files = {{"/cell/part_1.src", 0}, {"/cell/part_2.src", 6}};
  EXPECT_EQ(waypointAtLine(motion, {20, "part_1"}), (WaypointIndex{0, 0, 0}));
  EXPECT_EQ(waypointAtLine(motion, {22, "PART_2.SRC"}), (WaypointIndex{1, 0, 0}));
  EXPECT_EQ(waypointAtLine(motion, {1, "/cell/part_2.src"}), (WaypointIndex{0, 1, 0}));
  // Behind the last move of a file comes the first of the next one.
  EXPECT_EQ(waypointAtLine(motion, {60, "part_1"}), (WaypointIndex{0, 1, 0}));
  EXPECT_THROW(waypointAtLine(motion, {23, "part_2"}), InvalidInput);
  for (const StatedLine& line : {StatedLine{20, ""}, StatedLine{20, "part_3"}}) {
    try {
      waypointAtLine(motion, line);
      FAIL() << line.file;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("part_1.src, part_2.src"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace lamina
