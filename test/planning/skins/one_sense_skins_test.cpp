// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Skins that are seen are deposited in one sense across.
#include <gtest/gtest.h>

#include <cmath>

#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

/// A plate with three holes.
std::vector<Layer> holedPlate() {
  return test::layersOf(6, [](int) {
    return std::vector<Polygon>{test::rectangle(0, 0, 40, 30), test::reversed(test::circle({10, 12}, 4, 24)),
                                test::reversed(test::circle({28, 8}, 3, 24)),
                                test::reversed(test::rectangle(20, 18, 34, 25))};
  });
}

PlanSettings coveredPlate() {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.skins.top_layers = settings.skins.bottom_layers = 2;
  return settings;
}

/// Lines of the top skin that have one above them deposited before, at 135 deg in layer 5.
std::size_t depositedBelow(const ToolpathLayer& layer) {
  struct Row {
    double from, to, across;
  };
  std::vector<Row> rows;
  const Point2 along(-std::sqrt(0.5), std::sqrt(0.5));
  const Point2 across(-std::sqrt(0.5), -std::sqrt(0.5));
  for (const Path& path : layer.paths)
    for (std::size_t m = 0; path.role == PathRole::TopSkin && m < path.motionCount(); ++m) {
      const Point2 a = path.points[m].head<2>();
      const Point2 b = path.points[path.motionEnd(m)].head<2>();
      const double x = along.dot(a);
      const double y = along.dot(b);
      if (std::abs(x - y) < 2.0 || std::abs(across.dot(b - a)) > 1e-3) continue;
      rows.push_back({std::min(x, y), std::max(x, y), across.dot(a)});
    }
  EXPECT_GT(rows.size(), 50U);
  std::size_t count = 0;
  for (std::size_t later = 0; later < rows.size(); ++later)
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const double above = rows[earlier].across - rows[later].across;
      const double beside =
          std::min(rows[earlier].to, rows[later].to) - std::max(rows[earlier].from, rows[later].from);
      if (beside > 0.4 && above > 0.2 && above < 0.5) ++count;
    }
  return count;
}

double topSkinOf(const ToolpathLayer& layer) {
  double sum = 0.0;
  for (const Path& path : layer.paths)
    if (path.role == PathRole::TopSkin) sum += depositedVolume(path);
  return sum;
}

TEST(OneSenseSkins, LayNoLineBetweenTwoDepositedBeforeIt) {
  PlanSettings settings = coveredPlate();
  const ToolpathLayer one_sense = test::plan(holedPlate(), settings).layers[5];
  EXPECT_EQ(depositedBelow(one_sense), 0U);
  settings.skins.is_monotonic = false;
  const ToolpathLayer shortest = test::plan(holedPlate(), settings).layers[5];
  EXPECT_GT(depositedBelow(shortest), 0U) << "round the holes";
  EXPECT_NEAR(topSkinOf(one_sense), topSkinOf(shortest), 0.01 * topSkinOf(shortest));
}

TEST(OneSenseSkins, LeaveHiddenSkinsAsTheyAre) {
  PlanSettings settings = coveredPlate();
  const Toolpath one_sense = test::plan(holedPlate(), settings);
  settings.skins.is_monotonic = false;
  const Toolpath shortest = test::plan(holedPlate(), settings);
  for (std::size_t l = 0; l < 5; ++l)
    EXPECT_EQ(toolpathId({"", {one_sense.layers[l]}}), toolpathId({"", {shortest.layers[l]}})) << l;
}

}  // namespace
}  // namespace lamina
