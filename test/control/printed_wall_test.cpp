// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The loop on a disturbed process, layer by layer.
#include <gtest/gtest.h>

#include "support/printed_wall.hpp"

namespace lamina {
namespace {

using test::disturbedPlant;
using test::meanOfSeeds;
using test::PrintedWall;
using test::WallCase;

WallCase disturbedWall() {
  WallCase wall;
  wall.plant = disturbedPlant();
  return wall;
}

WallCase openWall() {
  WallCase wall = disturbedWall();
  wall.state = LoopState::Identifying;
  return wall;
}

double lateRmse(const PrintedWall& wall) { return wall.rmse(20, 40); }
double lateFlatness(const PrintedWall& wall) { return wall.flatness(20, 40); }

TEST(PrintedWall, IsCorrectedByNineTenths) {
  for (const bool is_closed : {false, true}) {
    WallCase wall = disturbedWall();
    WallCase open = openWall();
    wall.is_closed = open.is_closed = is_closed;
    EXPECT_GT(meanOfSeeds(open, lateRmse), 4.0) << "the process drifts without the loop";
    EXPECT_LT(meanOfSeeds(wall, lateRmse), 0.1 * meanOfSeeds(open, lateRmse));
    EXPECT_LT(meanOfSeeds(wall, lateFlatness), 0.1 * meanOfSeeds(open, lateFlatness));
    EXPECT_LT(meanOfSeeds(wall, lateRmse), 0.1);
  }
}

TEST(PrintedWall, IsTheSameEachTime) {
  EXPECT_EQ(test::printedWall(disturbedWall()).error_mm, test::printedWall(disturbedWall()).error_mm);
}

TEST(PrintedWall, WithoutDisturbanceIsAsPlanned) {
  WallCase wall;
  wall.noise_mm = 1e-9;
  wall.layers = 5;
  const PrintedWall printed = test::printedWall(wall);
  for (const double error : printed.error_mm) EXPECT_NEAR(error, 0.0, 1e-6);
}

}  // namespace
}  // namespace lamina
