// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "toolpath/path_motions.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

Path turningPath() {
  Path path;
  path.points = {{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 4.0, 0.0}};
  path.orientation = AlongPath<Eigen::Quaterniond>(
      std::vector<Eigen::Quaterniond>{{0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0}});
  return path;
}

TEST(PathMotions, HaveALength) {
  Path path = turningPath();
  EXPECT_EQ(motionLength(path, 1), 4.0);
  path.is_closed = true;
  EXPECT_EQ(motionLength(path, 2), 5.0);
}

TEST(PathMotions, EndAsTheNozzleStands) {
  Path path = turningPath();
  EXPECT_EQ(startOrientation(path).x(), 1.0);
  EXPECT_EQ(endOrientation(path).z(), 1.0);
  path.is_closed = true;
  EXPECT_EQ(endOrientation(path).x(), 1.0);
}

TEST(PathMotions, TakeValuesOfOtherWaypoints) {
  EXPECT_TRUE(picked(AlongPath<double>(2.0), {0, 4, 1}).isCommon());
  const AlongPath<double> values(std::vector<double>{5.0, 6.0, 7.0});
  EXPECT_EQ(picked(values, {2, 0, 0, 1}).values(), (std::vector<double>{7.0, 5.0, 5.0, 6.0}));
}

TEST(PathMotions, EndWithTheLastPathThereIs) {
  Toolpath toolpath;
  EXPECT_EQ(lastPath(toolpath), nullptr);
  toolpath.layers.resize(3);
  EXPECT_EQ(lastPath(toolpath), nullptr);
  toolpath.layers[1].paths.resize(2);
  EXPECT_EQ(lastPath(toolpath), &toolpath.layers[1].paths[1]);
}

}  // namespace
}  // namespace lamina
