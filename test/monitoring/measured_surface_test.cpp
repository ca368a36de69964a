// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/measured_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

MeasuredSurface tenByTen() { return MeasuredSurface(heightGrid({Point2(0, 0), Point2(10, 10)}, 1.0)); }

TEST(MeasuredSurface, IsUnknownWhereNothingWasSeen) {
  const MeasuredSurface surface = tenByTen();
  EXPECT_TRUE(std::isnan(surface.height(0)));
  EXPECT_EQ(heightRange(surface.heights()).known, 0u);
}

TEST(MeasuredSurface, HoldsTheMeanOfAPass) {
  MeasuredSurface surface = tenByTen();
  for (const double z : {1.0, 2.0, 6.0}) surface.insert({0.5, 0.5, z});
  EXPECT_DOUBLE_EQ(surface.height(0), 3.0);
  EXPECT_DOUBLE_EQ(surface.heightInPass(0), 3.0);
}

TEST(MeasuredSurface, ALaterPassReplacesWhatItSees) {
  MeasuredSurface surface = tenByTen();
  surface.insert({0.5, 0.5, 1.0});
  surface.insert({1.5, 0.5, 1.0});
  surface.beginPass();
  surface.insert({0.5, 0.5, 4.0});
  EXPECT_DOUBLE_EQ(surface.height(0), 4.0);
  EXPECT_DOUBLE_EQ(surface.height(1), 1.0);
  EXPECT_TRUE(std::isnan(surface.heightInPass(1)));
}

TEST(MeasuredSurface, LeavesOutPointsBeyondTheGridOrNotFinite) {
  MeasuredSurface surface = tenByTen();
  EXPECT_EQ(surface.insert({-0.1, 5, 1}), MeasuredSurface::Fused::Outside);
  EXPECT_EQ(surface.insert({NAN, 5, 1}), MeasuredSurface::Fused::Outside);
  EXPECT_EQ(surface.insert({5, 5, NAN}), MeasuredSurface::Fused::Outside);
  EXPECT_EQ(surface.insert({5, 5, INFINITY}), MeasuredSurface::Fused::Outside);
  EXPECT_EQ(heightRange(surface.heights()).known, 0u);
}

TEST(MeasuredSurface, NoiseAveragesOut) {
  MeasuredSurface surface = tenByTen();
  Random random(7);
  const int count = 100000;
  const double sigma = 0.05;
  for (int i = 0; i < count; ++i) surface.insert({0.5, 0.5, 2.0 + random.normal(0.0, sigma)});
  EXPECT_LE(std::abs(surface.height(0) - 2.0), 3.0 * sigma / std::sqrt(double(count)));
}

}  // namespace
}  // namespace lamina
