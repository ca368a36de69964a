// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/metal_split.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

LoopSettings wireSettings(double exponent) {
  LoopSettings settings;
  settings.speed_exponent = exponent;
  settings.heat = 1.0;
  return settings;
}

/// Half a bead gets a tenth more, half a tenth less, so that the wire stays.
std::vector<double> halves(const LayerCells& cells) {
  std::vector<double> amount(cells.size(), -0.1);
  for (std::size_t i = 0; i < cells.size() / 2; ++i) amount[i] = 0.1;
  return amount;
}

/// Growth goes with speed to the power a: a tenth more height asks for 19 % less speed at a = -0.46, but
/// for 38 % less at a = -0.2.
TEST(MetalSplit, GivesWhatIsFastToTheSpeed) {
  const LayerCells cells = test::straightBeads({0.0}, 40.0, 1.0);
  for (const double exponent : {-0.46, -0.2}) {
    const MetalCorrection split =
        metalSplit(cells, halves(cells), PowerSource::Follows, wireSettings(exponent));
    EXPECT_NEAR(split.wire, 0.0, 1e-12);
    EXPECT_NEAR(split.speed_mm_s[3] / 10.0 - 1.0, exponent == -0.46 ? -0.187 : -0.379, 1e-3);
    EXPECT_NEAR(split.power[3], split.speed_mm_s[3] / 10.0 - 1.0, 1e-12) << "heat per length stays";
  }
}

TEST(MetalSplit, GivesWhatIsSlowToTheWire) {
  const LayerCells cells = test::straightBeads({0.0}, 40.0, 1.0);
  const std::vector<double> amount(cells.size(), 0.2);
  const MetalCorrection split = metalSplit(cells, amount, PowerSource::Fixed, wireSettings(-0.3));
  EXPECT_NEAR(split.wire, 0.2, 1e-12);
  for (const double speed : split.speed_mm_s) EXPECT_NEAR(speed, 10.0, 1e-9);
  EXPECT_EQ(split.limited_share, 0.0);
}

TEST(MetalSplit, KeepsSpeedAndHeatWithinTheirWindows) {
  const LayerCells cells = test::straightBeads({0.0}, 40.0, 1.0);
  LoopSettings settings = wireSettings(-0.2);
  settings.heat = 0.15;
  const MetalCorrection fixed = metalSplit(cells, halves(cells), PowerSource::Fixed, settings);
  EXPECT_NEAR(fixed.speed_mm_s[3], 10.0 / 1.15, 1e-9) << "slower is hotter";
  EXPECT_NEAR(fixed.speed_mm_s[30], 10.0 / 0.85, 1e-9);
  EXPECT_EQ(fixed.limited_share, 1.0);
  const MetalCorrection follows = metalSplit(cells, halves(cells), PowerSource::Follows, settings);
  EXPECT_EQ(follows.speed_mm_s[30], 10.0 * std::pow(0.9, -5.0));
  settings.greatest_speed_mm_s = 12.0;
  EXPECT_EQ(metalSplit(cells, halves(cells), PowerSource::Follows, settings).speed_mm_s[30], 12.0);
}

TEST(MetalSplit, TellsWhatIsLaidWithinTheWindows) {
  const LayerCells cells = test::straightBeads({0.0}, 40.0, 1.0);
  LoopSettings settings = wireSettings(-0.2);
  settings.heat = 0.15;
  const MetalCorrection limited = metalSplit(cells, halves(cells), PowerSource::Fixed, settings);
  EXPECT_NEAR(limited.amount[3], std::pow(1.15, 0.2) - 1.0, 1e-12) << "2.8 % of the tenth";
  EXPECT_NEAR(limited.amount[30], std::pow(0.85, 0.2) - 1.0, 1e-12);
  EXPECT_EQ(metalSplit(cells, halves(cells), PowerSource::Follows, settings).amount, halves(cells));
}

TEST(MetalSplit, AsksForAnExponent) {
  const LayerCells cells = test::straightBeads({0.0}, 40.0, 1.0);
  EXPECT_THROW(metalSplit(cells, halves(cells), PowerSource::Fixed, LoopSettings()), InvalidConfig);
}

TEST(MetalSplit, RefusesWhatLeavesNoSpeed) {
  const LayerCells cells = test::straightBeads({0.0}, 40.0, 1.0);
  LoopSettings settings = wireSettings(-0.3);
  settings.heat = 0.15;
  settings.greatest_speed_mm_s = 8.0;  // 10 mm/s less 15 % of heat is 8.7 mm/s
  EXPECT_THROW(metalSplit(cells, halves(cells), PowerSource::Fixed, settings), InvalidInput);
  EXPECT_NO_THROW(metalSplit(cells, halves(cells), PowerSource::Follows, settings));
  settings.least_speed_mm_s = 9.0;
  EXPECT_THROW(metalSplit(cells, halves(cells), PowerSource::Follows, settings), InvalidConfig);
}

}  // namespace
}  // namespace lamina
