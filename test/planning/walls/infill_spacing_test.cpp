// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/infill_spacing.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

InfillSettings settingsOf(double pitch_mm, int outer_layers = 0, double outer_pitch_mm = 0.0) {
  InfillSettings settings;
  settings.pitch_mm = pitch_mm;
  settings.outer_layers = outer_layers;
  settings.outer_pitch_mm = outer_pitch_mm;
  return settings;
}

TEST(InfillSpacingTest, FollowsTheDensityWhereNoPitchIsGiven) {
  InfillSettings settings;
  settings.density = 0.25;
  EXPECT_DOUBLE_EQ(infillSpacing(settings, 0.4, {3, 10}).spacing_mm, 1.6);
  EXPECT_DOUBLE_EQ(infillSpacing(settings, 0.4, {3, 10}).pitch_mm, 0.4);
  settings.density = 1.0;
  EXPECT_TRUE(isSolid(infillSpacing(settings, 0.4, {3, 10})));
  settings.density = 0.0;
  EXPECT_EQ(infillSpacing(settings, 0.4, {3, 10}).spacing_mm, 0.0);
}

TEST(InfillSpacingTest, APitchUpToAQuarterAboveThatOfTheBeadIsSolid) {
  EXPECT_TRUE(isSolid(infillSpacing(settingsOf(0.3), 0.4, {3, 10})));
  EXPECT_DOUBLE_EQ(infillSpacing(settingsOf(0.3), 0.4, {3, 10}).pitch_mm, 0.3);
  EXPECT_TRUE(isSolid(infillSpacing(settingsOf(0.5), 0.4, {3, 10})));
  const InfillSpacing sparse = infillSpacing(settingsOf(1.0), 0.4, {3, 10});
  EXPECT_FALSE(isSolid(sparse));
  EXPECT_DOUBLE_EQ(sparse.spacing_mm, 1.0);
  EXPECT_DOUBLE_EQ(sparse.pitch_mm, 0.4);
  try {
    infillSpacing(settingsOf(0.1), 0.4, {3, 10});
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_STREQ(error.what(),
                 "infill.pitch_mm is 0.1 mm; must be 0 or at least 0.2 mm, half of what a bead fills");
  }
}

TEST(InfillSpacingTest, FirstAndLastLayersHaveAPitchOfTheirOwn) {
  const InfillSettings settings = settingsOf(1.0, 2, 0.35);
  for (const std::size_t outer : {0, 1, 8, 9})
    EXPECT_DOUBLE_EQ(infillSpacing(settings, 0.4, {outer, 10}).spacing_mm, 0.35);
  for (const std::size_t inner : {2, 5, 7})
    EXPECT_DOUBLE_EQ(infillSpacing(settings, 0.4, {inner, 10}).spacing_mm, 1.0);
  EXPECT_DOUBLE_EQ(infillSpacing(settingsOf(1.0, 2), 0.4, {0, 10}).spacing_mm, 0.4);
  EXPECT_DOUBLE_EQ(infillSpacing(settings, 0.4, {0, 1}).spacing_mm, 0.35);
}

/// Material deposited in each layer of a block of 20 x 20 mm.
std::vector<double> volumesOf(const PlanSettings& settings) {
  const auto square = [](int) { return std::vector<Polygon>{test::rectangle(0, 0, 20, 20)}; };
  std::vector<double> volumes;
  for (const ToolpathLayer& layer : test::plan(test::layersOf(8, square), settings).layers) {
    volumes.push_back(0.0);
    for (const Path& path : layer.paths) volumes.back() += depositedVolume(path);
  }
  return volumes;
}

TEST(InfillSpacingTest, LayersHoldOneBeadAPitch) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.walls.count = 0;
  settings.bead.width_mm = 0.443;  // fills 0.4 mm of 0.2 mm: 0.08 mm²
  settings.infill = settingsOf(1.6, 2, 0.32);
  settings.infill.strategy = "contour";
  const std::vector<double> volumes = volumesOf(settings);
  const double area = 400.0;
  const double loops_mm = 4.0 * (19.6 + 16.4 + 13.2 + 10.0 + 6.8 + 3.6 + 0.4);
  for (const std::size_t outer : {0, 1, 6, 7}) EXPECT_NEAR(volumes[outer], area * 0.08 / 0.32, 0.02 * 100.0);
  for (const std::size_t inner : {2, 3, 4, 5}) EXPECT_NEAR(volumes[inner], loops_mm * 0.08, 0.02 * 22.4);
  settings.infill = settingsOf(0.45);
  settings.infill.strategy = "contour";
  for (const double volume : volumesOf(settings)) EXPECT_NEAR(volume, area * 0.08 / 0.45, 0.02 * 71.0);
}

TEST(InfillSpacingTest, TheOutermostLineStaysHalfABeadInside) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.walls.count = 0;
  for (const double pitch : {0.0, 0.3, 0.44}) {
    settings.infill = settingsOf(pitch);
    settings.infill.density = 1.0;
    settings.infill.strategy = "contour";
    const auto square = [](int) { return std::vector<Polygon>{test::rectangle(0, 0, 20, 20)}; };
    const Box3 box = depositionBox(test::plan(test::layersOf(1, square), settings));
    EXPECT_NEAR(box.low.x(), 0.2, 1e-6) << pitch;
    EXPECT_NEAR(box.high.y(), 19.8, 1e-6) << pitch;
  }
}

}  // namespace
}  // namespace lamina
