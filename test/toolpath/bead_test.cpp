// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

TEST(Bead, FillsLessThanItsWidthByTheCornersOfItsStadium) {
  // 0.2 x 0.2 between two half discs of 0.2: 0.04 + 0.01 pi over a height of 0.2.
  EXPECT_NEAR(planWidth({0.4, 0.2}), 0.2 + 0.05 * M_PI, 1e-12);
  EXPECT_NEAR(planWidth({0.2, 0.2}), 0.05 * M_PI, 1e-12);
  EXPECT_EQ(planWidth({0.4, 0.0}), 0.4);
}

TEST(Bead, OfAnAreaHasThatArea) {
  for (const double area : {1e-6, 0.01, 0.02, 0.0314, 0.05, 0.3, 7.0})
    for (const double height : {0.05, 0.2, 1.0}) {
      const Bead bead = beadOfArea(area, height);
      EXPECT_EQ(bead.height_mm, height);
      EXPECT_NEAR(crossSection(bead), area, 1e-12);
    }
  EXPECT_EQ(beadOfArea(0.0, 0.2).width_mm, 0.0);
}

TEST(Drops, HoldOneDiscPerWaypoint) {
  Path path;
  path.deposit = Deposit::Drops;
  path.points = {{0, 0, 0.2}, {1, 0, 0.2}, {2, 0, 0.2}};
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 10.0;
  EXPECT_NEAR(depositedVolume(path), 3 * M_PI * 0.04 * 0.2, 1e-12);
  path.bead = AlongPath<Bead>(std::vector<Bead>{{0.4, 0.2}, {0.2, 0.2}, {0.0, 0.2}});
  EXPECT_NEAR(depositedVolume(path), M_PI * (0.04 + 0.01) * 0.2, 1e-12);
}

TEST(Drops, MayBeASingleOne) {
  Path path;
  path.deposit = Deposit::Drops;
  path.points = {{0, 0, 0.2}};
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 10.0;
  EXPECT_NO_THROW(validate({"part", {{0.2, 0.2, {path}}}}));
  path.deposit = Deposit::Bead;
  EXPECT_ANY_THROW(validate({"part", {{0.2, 0.2, {path}}}}));
}

}  // namespace
}  // namespace lamina
