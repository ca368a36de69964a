// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/fill_path.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

FillPath threePoints() {
  FillPath path;
  path.points = {{0, 0}, {1, 0}, {1, 2}};
  path.width_mm = {0.5, 0.1, 0.2};
  return path;
}

TEST(FillPath, TurnedRoundKeepsTheWidthOfEachMotion) {
  const FillPath path = reversed(threePoints());
  EXPECT_EQ(path.points, (Polyline{{1, 2}, {1, 0}, {0, 0}}));
  EXPECT_EQ(path.width_mm[1], 0.2) << "between (1, 2) and (1, 0)";
  EXPECT_EQ(path.width_mm[2], 0.1);
}

TEST(FillPath, TurnedRoundKeepsTheWidthOfItsReturn) {
  FillPath path = threePoints();
  path.is_closed = true;
  EXPECT_EQ(reversed(path).width_mm[0], 0.5) << "between (1, 2) and (0, 0)";
}

TEST(FillPath, EndsWhereItStartsIfItIsClosed) {
  FillPath path = threePoints();
  EXPECT_EQ(lastPoint(path), Point2(1, 2));
  path.is_closed = true;
  EXPECT_EQ(lastPoint(path), Point2(0, 0));
}

}  // namespace
}  // namespace lamina
