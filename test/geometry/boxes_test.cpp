// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/boxes.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(Boxes, OverlapWhereTheyTouch) {
  const Box2 box{{0.0, 0.0}, {2.0, 1.0}};
  EXPECT_TRUE(areOverlapping(box, Box2{{2.0, 1.0}, {3.0, 3.0}}));
  EXPECT_TRUE(areOverlapping(box, Box2{{0.5, -1.0}, {0.6, 4.0}}));
  EXPECT_FALSE(areOverlapping(box, Box2{{2.1, 0.0}, {3.0, 1.0}}));
  EXPECT_FALSE(areOverlapping(box, Box2()));
}

TEST(Boxes, HoldTheirBorder) {
  const Box3 box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
  EXPECT_TRUE(isInBox(box, Point3(1.0, 0.0, 0.5)));
  EXPECT_FALSE(isInBox(box, Point3(1.0, 0.0, 1.5)));
}

}  // namespace
}  // namespace lamina
