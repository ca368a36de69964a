// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/solid_cells.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(SolidCells, AreThoseLeftBehindEarlyEnough) {
  SolidCells solid;
  EXPECT_EQ(solid.leftBehindBy(100), 0U);
  solid.leaveBehind(10, 0);
  solid.leaveBehind(20, 3);
  solid.leaveBehind(25, 3);
  solid.leaveBehind(30, 5);
  EXPECT_EQ(solid.leftBehindBy(5), 0U);
  EXPECT_EQ(solid.leftBehindBy(19), 0U);
  EXPECT_EQ(solid.leftBehindBy(20), 3U);
  EXPECT_EQ(solid.leftBehindBy(29), 3U);
  EXPECT_EQ(solid.leftBehindBy(40), 5U);
  solid.begin();
  EXPECT_EQ(solid.leftBehindBy(50), 0U);
}

}  // namespace
}  // namespace lamina
