// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/strand.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

TEST(Strand, RadiusStartsFromTheStadium) {  // 199.7 and 198.9 um in [Vega2023, annexes H and G]
  const double radius_mm = strandRadius(crossSection({0.48, 0.30}));
  EXPECT_NEAR(radius_mm, 0.19922, 1e-5);
  EXPECT_NEAR(radius_mm / 0.1997, 1.0, 0.005);
  EXPECT_NEAR(radius_mm / 0.1989, 1.0, 0.005);
}

TEST(Strand, TheBallHoldsTheVolume) { EXPECT_NEAR(ballRadius(4.0 / 3.0 * M_PI * 8.0), 2.0, 1e-12); }

TEST(Strand, RadiusIsCalibratedAsInTheSource) {  // annex G: radius [mm], volume [mm3]
  const std::vector<RadiusTrial> trials{
      {0.150, 197.5}, {0.200, 359.034}, {0.1988, 354.73}, {0.19892, 355.159}};
  EXPECT_NEAR(calibratedRadius(trials, 355.17), 0.198923, 2e-6);
}

TEST(Strand, TwoTrialsGiveAStraightLine) {
  EXPECT_NEAR(calibratedRadius({{1.0, 10.0}, {2.0, 30.0}}, 15.0), 1.25, 1e-12);
}

TEST(Strand, FewOrEqualTrialsAreRefused) {
  EXPECT_THROW(calibratedRadius({{1.0, 10.0}}, 15.0), InvalidInput);
  EXPECT_THROW(calibratedRadius({{1.0, 10.0}, {2.0, 10.0}}, 15.0), InvalidInput);
}

}  // namespace
}  // namespace lamina
