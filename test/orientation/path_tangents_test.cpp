// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/path_tangents.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/toolpaths.hpp"

namespace lamina {
namespace {

const double kHalf = std::sqrt(0.5);

TEST(PathTangents, CornersOfAClosedPathHaveTheMeanOfBothSides) {
  const Path square = test::twoLayers().layers[0].paths[0];
  const std::vector<Point3> tangents = pathTangents(square);
  ASSERT_EQ(tangents.size(), 4U);
  EXPECT_LE((tangents[0] - Point3(kHalf, -kHalf, 0)).norm(), 1e-12);
  EXPECT_LE((tangents[1] - Point3(kHalf, kHalf, 0)).norm(), 1e-12);
}

TEST(PathTangents, EndsOfAnOpenPathHaveTheirOnlyMotion) {
  Path path = test::straightPath({0, 0, 0}, {2, 0, 0});
  path.points.emplace_back(2, 5, 0);
  const std::vector<Point3> tangents = pathTangents(path);
  ASSERT_EQ(tangents.size(), 3U);
  EXPECT_EQ(tangents[0], Point3(1, 0, 0));
  EXPECT_LE((tangents[1] - Point3(kHalf, kHalf, 0)).norm(), 1e-12);
  EXPECT_EQ(tangents[2], Point3(0, 1, 0));
}

TEST(PathTangents, MotionsWithoutLengthHaveNoSay) {
  Path path = test::straightPath({0, 0, 0}, {0, 0, 0});
  path.points.emplace_back(0, 3, 0);
  path.points.emplace_back(0, 3, 0);
  for (const Point3& tangent : pathTangents(path)) EXPECT_EQ(tangent, Point3(0, 1, 0));
  EXPECT_EQ(motionLengths(path), (std::vector<double>{0.0, 3.0, 0.0}));
}

TEST(PathTangents, AtAReversalTheWayOnCounts) {
  Path path = test::straightPath({0, 0, 0}, {1, 0, 0});
  path.points.emplace_back(0.5, 0, 0);
  EXPECT_EQ(pathTangents(path)[1], Point3(-1, 0, 0));
}

TEST(PathTangents, ASingleDropHasNone) {
  Path drop;
  drop.deposit = Deposit::Drops;
  drop.points = {{1, 2, 3}};
  EXPECT_TRUE(pathTangents(drop).empty());
}

}  // namespace
}  // namespace lamina
