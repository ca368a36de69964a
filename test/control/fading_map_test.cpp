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

}  // namespace
}  // namespace lamina
