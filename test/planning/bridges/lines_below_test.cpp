// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/bridges/lines_below.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

double linesMet(const std::vector<double>& lines_deg, double way_deg) {
  double met = 0.0;
  for (const double line : lines_deg) met += std::abs(std::sin((way_deg - line) * M_PI / 180.0));
  return met;
}

TEST(LinesBelow, AreCrossedAtARightAngleWhereTheyAreParallel) {
  EXPECT_DOUBLE_EQ(acrossLines({30.0}), 120.0);
}

TEST(LinesBelow, OfAGridAreCrossedBetweenBoth) {
  EXPECT_NEAR(std::abs(std::remainder(acrossLines({45.0, 135.0}), 90.0)), 0.0, 1e-9);
  EXPECT_NEAR(linesMet({45.0, 135.0}, acrossLines({45.0, 135.0})), std::sqrt(2.0), 1e-12) << "1 across one";
}

TEST(LinesBelow, OfThreeWaysAreCrossedAtARightAngleToOne) {
  EXPECT_NEAR(std::abs(std::remainder(acrossLines({10.0, 70.0, 130.0}) - 100.0, 60.0)), 0.0, 1e-9);
}

TEST(LinesBelow, AreMetMostOften) {
  EXPECT_TRUE(rc::check("random directions", [](std::uint64_t seed) {
    Random random(seed);
    std::vector<double> lines(1 + random.below(5));
    for (double& line : lines) line = random.uniform(-360.0, 360.0);
    const double met = linesMet(lines, acrossLines(lines));
    for (double way = 0.0; way < 180.0; way += 0.5) RC_ASSERT(met > linesMet(lines, way) - 1e-6);
  }));
}

TEST(LinesBelow, TurnWithTheLayerButForPatterns) {
  InfillSettings settings;
  settings.angle_deg = 20.0;
  settings.alternation_deg = 60.0;
  EXPECT_EQ(linesOf(infillStrategy("zigzag"), settings, 2), (std::vector<double>{140.0}));
  EXPECT_EQ(linesOf(infillStrategy("grid"), settings, 2), (std::vector<double>{20.0, 110.0}));
  EXPECT_EQ(linesOf(infillStrategy("honeycomb"), settings, 5), (std::vector<double>{20.0, 80.0, 140.0}));
}

}  // namespace
}  // namespace lamina
