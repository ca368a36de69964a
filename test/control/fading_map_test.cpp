// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/fading_map.hpp"

#include <gtest/gtest.h>

#include "support/control_layers.hpp"

namespace lamina {
namespace {

/// 0.5 /s at 10 mm/s are 0.05 per mm: 1.2 fade over 24 mm, beyond the first bead of 20 mm.
TEST(FadingMap, GoesOnFromPathToPath) {
  const ToolpathLayer layer = test::straightBeadLayer({0.0, 3.0, 6.0}, 20.0);
  const CorrectionMap map = fadingMap(layer, 4, 1.2, 1.0, LoopSettings());
  EXPECT_EQ(map.layer, 4U);
  ASSERT_EQ(map.paths.size(), 2U) << "the third bead is as planned";
  EXPECT_NEAR(map.paths[0].stations.front().amount, 1.15, 1e-12);
  EXPECT_NEAR(map.paths[0].stations.back().amount, 0.2, 1e-12);
  EXPECT_NEAR(map.paths[1].stations[0].amount, 0.15, 1e-12);
  EXPECT_NEAR(map.paths[1].stations[3].amount, 0.0, 1e-12);
  EXPECT_TRUE(fadingMap(layer, 4, 0.0, 1.0, LoopSettings()).paths.empty());
}

/// The support behind the first bead is as planned, and so is the bead behind that.
TEST(FadingMap, EndsAtSupport) {
  ToolpathLayer layer = test::straightBeadLayer({0.0, 3.0, 6.0}, 20.0);
  layer.paths[2].role = PathRole::Support;
  const CorrectionMap map = fadingMap(layer, 4, 1.2, 1.0, LoopSettings());
  ASSERT_EQ(map.paths.size(), 1U);
  EXPECT_EQ(map.paths[0].path, 0U);
}

TEST(FadingMap, BeginsWithTheLastAmountOfTheLayerBefore) {
  const ToolpathLayer layer = test::straightBeadLayer({0.0, 3.0}, 20.0);
  const LayerCells cells = layerCells(layer, 0, 1.0);
  std::vector<double> amounts(cells.size(), 0.1);
  amounts.back() = 0.3;
  CorrectionMap map = correctionMap(cells, {amounts, {}, {}}, "part", 1);
  EXPECT_EQ(lastAmount(map, layer), 0.3);
  map.paths.pop_back();
  EXPECT_EQ(lastAmount(map, layer), 0.0) << "the last bead is as planned";
  EXPECT_EQ(lastAmount({}, layer), 0.0);
}

/// As the loop has it of its cells: from 0.3 to 0.1 on the first bead, within 4 mm, and on to -0.2 at once.
TEST(FadingMap, GoesOverToTheAmountsOfAnotherMap) {
  const ToolpathLayer layer = test::straightBeadLayer({0.0, 3.0}, 20.3);
  const LayerCells cells = layerCells(layer, 7, 1.0);
  std::vector<double> amounts(cells.size(), 0.1);
  std::fill(amounts.begin() + 21, amounts.end(), -0.2);
  const CorrectionMap coasting = correctionMap(cells, {amounts, {}, {}}, "part", 0);
  const CorrectionMap map = fadedMap(coasting, layer, 0.3, LoopSettings());
  const std::vector<double> before(cells.size(), 0.3);
  const std::vector<double> expected = fadedCorrection(cells, before, amounts, 0, LoopSettings());
  const double step = 0.05 * 20.3 / 21.0;
  EXPECT_NEAR(map.paths[0].stations[0].amount, 0.3 - step, 1e-12);
  EXPECT_EQ(map.paths[0].stations[5].amount, 0.1);
  EXPECT_EQ(map.paths[1].stations[0].amount, -0.2);
  for (std::size_t i = 0; i < 21; ++i) EXPECT_NEAR(map.paths[0].stations[i].amount, expected[i], 1e-12) << i;
}

}  // namespace
}  // namespace lamina
