// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/offset_watches.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/random.hpp"
#include "lamina/control/loop_settings.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

constexpr double kPassSpeed = 48.0;   // mm/s
constexpr double kPointSigma = 0.02;  // mm

/// A sensor that sees a dent of 0.3 mm there and back, by stamps that are that late.
void seeDent(OffsetWatches& watches, const std::string& sensor, const LayerCells& cells, double late_s) {
  Random random(7);
  for (const double sense : {1.0, -1.0})
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double at = (cells.along_mm[i] - sense * kPassSpeed * late_s - 30.0) / 5.0;
      const double error = 0.3 * std::exp(-0.5 * at * at) + random.normal(0.0, kPointSigma);
      watches.see(sensor, i, sense * kPassSpeed, {error, 1, kPointSigma});
    }
}

/// The mean of both is 0.
TEST(OffsetWatches, TellSensorsThatMovedApart) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 0.5);
  OffsetWatches watches;
  watches.begin(cells.size());
  seeDent(watches, "left", cells, 0.02);
  seeDent(watches, "right", cells, -0.02);
  const auto worst = watches.offset(cells, {});
  ASSERT_TRUE(worst);
  EXPECT_NEAR(std::abs(worst->left.offset_s), 0.02, 0.005);
  EXPECT_EQ(worst->sensor, worst->left.offset_s > 0.0 ? "left" : "right");
  EXPECT_GT(worst->sigmas(), 3.0);
}

/// Both are off alike; of one that is known.
TEST(OffsetWatches, GoByHowWellEachSensorIsKnown) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 0.5);
  OffsetWatches watches;
  watches.begin(cells.size());
  seeDent(watches, "left", cells, 0.02);
  seeDent(watches, "right", cells, 0.02);
  const auto moved = watches.offset(cells, {0.002, {{"left", 0.1}}});
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->sensor, "right");
  EXPECT_GT(moved->sigmas(), 3.0);
  EXPECT_LT(watches.offset(cells, {0.1, {}})->sigmas(), 1.0);
}

/// The mean of both would be half of it.
TEST(OffsetWatches, NameTheSensorThatMoved) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 0.5);
  OffsetWatches watches;
  watches.begin(cells.size());
  seeDent(watches, "left", cells, 0.0);
  seeDent(watches, "right", cells, 0.02);
  const auto moved = watches.offset(cells, {0.003, {}});
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->sensor, "right");
  EXPECT_NEAR(moved->left.offset_s, 0.02, 0.005);
  EXPECT_GE(moved->left.sigma_s, std::hypot(0.003, 0.001)) << "that of the calibrated one, and of stamps";
  SensorWatch seen;
  judge(*moved, seen);
  seen.is_scanning = true;
  LoopStatus active;
  active.state = LoopState::Active;
  const LoopStep step = afterWatch(active, seen, LoopSettings());
  ASSERT_EQ(step.alarms.size(), 1U);
  EXPECT_EQ(step.alarms[0].alarm, LoopAlarm::TimeOffset);
  EXPECT_EQ(step.alarms[0].reason.find("the time offset of sensor 'right' has moved by"), 0U)
      << step.alarms[0].reason;
}

TEST(OffsetWatches, SayNothingOfALayerThatNobodyRead) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 0.5);
  OffsetWatches watches;
  watches.begin(cells.size());
  seeDent(watches, "left", cells, 0.02);
  watches.begin(cells.size());
  EXPECT_FALSE(watches.offset(cells, {}));
  EXPECT_EQ(SensorOffset().sigmas(), 0.0);
}

}  // namespace
}  // namespace lamina
