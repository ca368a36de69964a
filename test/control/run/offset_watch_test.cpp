// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/offset_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lamina/base/random.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

constexpr double kScanSpeed = 48.0;  // mm/s
constexpr double kSeenNoise = 0.02;  // mm

/// A bump of 0.3 mm amid the bead.
double bump(double along_mm) { return -0.3 * std::exp(-0.5 * std::pow((along_mm - 30.0) / 5.0, 2)); }

/// Seen there and back by a sensor whose stamps are that late.
OffsetWatch seenLate(const LayerCells& cells, double late_s, double relief) {
  Random random(3);
  OffsetWatch watch;
  watch.begin(cells.size());
  for (const double sense : {1.0, -1.0})
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double error = relief * bump(cells.along_mm[i] - sense * kScanSpeed * late_s);
      watch.see(i, sense * kScanSpeed, {error + random.normal(0.0, kSeenNoise), 1, kSeenNoise});
    }
  return watch;
}

TEST(OffsetWatch, FindsHowLateStampsAre) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 0.5);
  for (const double late_s : {-0.03, -0.005, 0.0, 0.005, 0.03}) {
    const auto left = seenLate(cells, late_s, 1.0).offset(cells);
    ASSERT_TRUE(left) << late_s;
    EXPECT_NEAR(left->offset_s, late_s, 4.0 * left->sigma_s + 0.1 * std::abs(late_s));
    EXPECT_LT(left->sigma_s, 0.002);
  }
}

TEST(OffsetWatch, SaysNothingOfALayerThatTellsNothing) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 0.5);
  EXPECT_FALSE(seenLate(cells, 0.03, 0.0).offset(cells)) << "an even layer";
  OffsetWatch one_sense;
  one_sense.begin(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    one_sense.see(i, kScanSpeed, {bump(cells.along_mm[i]), 1, kSeenNoise});
  EXPECT_FALSE(one_sense.offset(cells)) << "seen in one sense alone";
  EXPECT_FALSE(OffsetWatch().offset(cells)) << "of another layer";
}

TEST(OffsetWatch, LeavesOutWhatSaysNothing) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 0.5);
  OffsetWatch watch = seenLate(cells, 0.0, 1.0);
  const auto before = watch.offset(cells);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  watch.see(60, kNone, {9.0, 1, kSeenNoise});
  watch.see(60, 0.5, {9.0, 1, kSeenNoise});
  watch.see(60, kScanSpeed, {kNone, 1, kSeenNoise});
  watch.see(cells.size(), kScanSpeed, {9.0, 1, kSeenNoise});
  EXPECT_EQ(watch.offset(cells)->offset_s, before->offset_s);
}

}  // namespace
}  // namespace lamina
