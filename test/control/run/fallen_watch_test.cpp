// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/fallen_watch.hpp"

#include <gtest/gtest.h>

#include "support/control_layers.hpp"

namespace lamina {
namespace {

/// A bead of 60 mm in cells of 1 mm, 3 mm wide, of which the sensor saw the first and the last ones.
class FallenWatchTest : public testing::Test {
 protected:
  FallenWatchTest()
      : cells_(test::straightBeads({0.0}, 60.0, 1.0)), estimates_(60, CellEstimate(0.0, 0.05, 1.0)) {}

  void seeAllBut(std::size_t first, std::size_t end) {
    for (std::size_t i = 0; i < estimates_.size(); ++i)
      if (i < first || i >= end) estimates_[i].see({0.0, 6, 0.02}, 0.0);
  }

  LayerCells cells_;
  std::vector<CellEstimate> estimates_;
  FallenWatch watch_;
};

TEST_F(FallenWatchTest, FindsAPieceThatCameOff) {
  seeAllBut(20, 50);
  for (std::size_t i = 20; i < 50; i += 2) {
    watch_.see(i, 22.0);
    watch_.see(i, 21.0);
  }
  const FallenLength fallen = watch_.fallen(cells_, estimates_);
  EXPECT_NEAR(fallen.share, 0.5, 1e-12);
  EXPECT_NEAR(fallen.depth_mm, 21.0, 1e-12) << "the highest point";
  watch_.reset();
  EXPECT_EQ(watch_.fallen(cells_, estimates_).share, 0.0);
}

TEST_F(FallenWatchTest, FindsNothingWhereCellsAreSeenOrHardlyAnyPointIsLow) {
  seeAllBut(20, 50);
  for (std::size_t i = 0; i < 20; ++i) watch_.see(i, 21.0);
  for (std::size_t i = 20; i < 50; i += 4) watch_.see(i, 21.0);
  EXPECT_EQ(watch_.fallen(cells_, estimates_).share, 0.0);
}

TEST_F(FallenWatchTest, FindsNothingBesideTheEndsOfABead) {
  seeAllBut(0, 8);  // 8 mm, of three times 3 mm
  for (std::size_t i = 0; i < 8; ++i) watch_.see(i, 21.0);
  EXPECT_EQ(watch_.fallen(cells_, estimates_).share, 0.0);
}

}  // namespace
}  // namespace lamina
