// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/chart_outline.hpp"

#include <gtest/gtest.h>

#include "lamina/parameterization/layer_charts.hpp"
#include "lamina/parameterization/surface_cut.hpp"
#include "support/surfaces.hpp"

namespace lamina {
namespace {

using namespace test;

TEST(PlanOutline, APlateHasItsFourSides) {
  const std::vector<LayerChart> charts = layerCharts(layerOf(plateMesh(4, 3, 4.0, 3.0)), {});
  ASSERT_EQ(charts.size(), 1U);
  const std::vector<Polygon> outlines = outlineOf(charts[0]);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_EQ(outlines[0].size(), 14U);
  EXPECT_NEAR(signedArea(outlines[0]), 12.0, 1e-12);
  EXPECT_NEAR(perimeter(outlines[0]), 14.0, 1e-12);
}

TEST(PlanOutline, HolesRunClockwise) {
  const LayerSurface plate = layerOf(plateMesh(10, 10, 10.0, 10.0));
  std::vector<std::uint32_t> kept;
  for (std::uint32_t cell = 0; cell < 100; ++cell)
    if (cell % 10 < 3 || cell % 10 > 6 || cell / 10 < 3 || cell / 10 > 6)
      kept.insert(kept.end(), {2 * cell, 2 * cell + 1});
  const std::vector<LayerChart> charts = layerCharts(pieceOf(plate, kept), {});
  ASSERT_EQ(charts.size(), 1U);
  const std::vector<Polygon> outlines = outlineOf(charts[0]);
  ASSERT_EQ(outlines.size(), 2U);
  EXPECT_NEAR(std::max(signedArea(outlines[0]), signedArea(outlines[1])), 100.0, 1e-9);
  EXPECT_NEAR(std::min(signedArea(outlines[0]), signedArea(outlines[1])), -16.0, 1e-9);
}

}  // namespace
}  // namespace lamina
