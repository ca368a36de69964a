// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What covers level layers and bent ones of one stack.
#include "job/modes/stack_skins.hpp"

#include <gtest/gtest.h>

#include "lamina/parameterization/chart_outline.hpp"
#include "support/charts.hpp"
#include "support/grown_parts.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

/// A step 0.4 mm high, x from 0 to 4 mm, before a limb up to x = 10: a level layer of 0.2 mm, and on it one
/// on a chart.
class StackSkins : public ::testing::Test {
 protected:
  StackSkins() {
    settings_.slicing.layer_height_mm = 0.2;
    settings_.planning.walls.count = 0;
    settings_.planning.infill.density = 0.2;
    settings_.planning.skins = SkinSettings();
    settings_.planning.skins.top_layers = 2;
    LayerChart chart = test::levelChart(10.0, 5);
    for (Point3& vertex : chart.surface.middle.vertices) vertex.z() += 0.3;
    for (Point3& tip : chart.surface.tip) tip.z() += 0.3;
    plans_ = {{{0.0, 0.2}, {{test::rectangle(0, 0, 10, 10)}, {}}}, {{0.2, 0.4}, {outlineOf(chart), {}}}};
    charts_ = {{}, {chart}};
    part_ = test::lyingPrism({{{0, 0}, {10, 0}, {10, 3}, {4, 3}, {4, 0.4}, {0, 0.4}}, {}}, 10.0);
    for (Point3& vertex : part_.vertices) vertex.y() += 5.0;
  }

  std::vector<LayerCover> covers(const std::vector<bool>& is_skin) {
    NoProgress nobody;
    return coversOfStack({plans_, charts_, is_skin}, part_, settings_, nobody);
  }

  JobSettings settings_;
  std::vector<Layer> plans_;
  std::vector<std::vector<LayerChart>> charts_;
  Mesh part_;
};

TEST_F(StackSkins, EndAtTheLimbOnLevelAndOnBentLayers) {
  const std::vector<LayerCover> found = covers({false, false});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(area(*found[0].above), 100.0, 1e-3) << "the step goes on for a layer";
  EXPECT_NEAR(area(*found[0].whole), 60.0, 1e-3) << "and no farther";
  EXPECT_NEAR(area(*found[1].above), 60.0, 10 * 0.5 * settings_.planning.bead.width_mm);
  EXPECT_NEAR(area(*found[1].whole), 60.0, 10 * 0.5 * settings_.planning.bead.width_mm);
}

TEST_F(StackSkins, AreNoneWhereNothingIsDivided) {
  EXPECT_EQ(covers({false, true})[1].material, nullptr) << "a skin as a whole";
  EXPECT_NE(covers({false, true})[0].material, nullptr);
  settings_.planning.infill.density = 1.0;
  EXPECT_TRUE(covers({false, false}).empty()) << "solid";
  settings_.planning.infill.density = 0.2;
  settings_.planning.skins.top_layers = 0;
  EXPECT_TRUE(covers({false, false}).empty()) << "no skins are asked for";
  settings_.planning.skins.top_layers = 2;
  part_ = Mesh();
  EXPECT_TRUE(covers({false, false}).empty()) << "a coat";
}

}  // namespace
}  // namespace lamina
