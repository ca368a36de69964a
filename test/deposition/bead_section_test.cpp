// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "deposition/bead_section.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

constexpr double kBeadSectionCell = 0.01;

TEST(BeadSection, IsAStadiumWhereCellsAreSmall) {
  const BeadSection section{0.4, 0.2, kBeadSectionCell};
  EXPECT_DOUBLE_EQ(topAbove(section, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(topAbove(section, 0.1), 0.2);
  EXPECT_NEAR(topAbove(section, 0.1 + 0.06), 0.1 + 0.08, 1e-12);  // 6, 8, 10
  EXPECT_NEAR(topAbove(section, 0.2), 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(topAbove(section, 0.2 + kBeadSectionCell), 0.0);
}

TEST(BeadSection, GrowsSteadilyWithTheWidth) {
  for (const double distance : {0.0, 0.05, 0.15, 0.3}) {
    double before = 0.0;
    for (double width = 0.0; width < 1.0; width += 0.001) {
      const double now = topAbove({width, 0.2, 0.1}, distance);
      EXPECT_GE(now, before - 1e-12);
      EXPECT_LT(now - before, 0.06) << "a step at " << width << " mm, " << distance << " mm from the line";
      before = now;
    }
  }
}

TEST(BeadSection, OfNoWidthIsNone) { EXPECT_DOUBLE_EQ(topAbove({0.0, 0.2, 0.1}, 0.0), 0.0); }

TEST(BeadSection, WidthOnFlatGroundIsThatOfTheStadium) {
  EXPECT_NEAR(widthOnFlatGround(crossSection({0.4, 0.2}), 0.2), 0.4, 1e-12);
  EXPECT_NEAR(widthOnFlatGround(M_PI * 0.01, 0.4), 0.2, 1e-12);
  EXPECT_NEAR(discDiameter(M_PI * 0.01), 0.2, 1e-12);
}

}  // namespace
}  // namespace lamina
