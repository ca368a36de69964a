// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/lift/chart_lift.hpp"
#include "lamina/planning/planner.hpp"
#include "support/charts.hpp"
#include "support/path_spacing.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::layersOf;
using test::rectangle;

constexpr double kLength = 12.0;
constexpr std::uint32_t kLiftedLayersSides = 48;

/// Half cylinders on each other, and what is planned on them.
struct Stack {
  std::vector<std::vector<LayerChart>> charts;
  std::vector<double> highest_mm;  ///< nozzle tips, up to and with each layer
  std::vector<Layer> layers;

  void add(const LayerChart& chart) {
    double z = chart.surface.tip.front().z();
    for (const Point3& tip : chart.surface.tip) z = std::max(z, tip.z());
    charts.push_back({chart});
    highest_mm.push_back(z);
  }
};

Stack halfCylinders(int count) {
  Stack stack;
  for (int i = 0; i < count; ++i)
    stack.add(test::halfCylinder(5.1 + test::kLayerHeight * i, kLength, kLiftedLayersSides));
  stack.layers = layersOf(count, [&](int i) {
    const Point2 corner = stack.charts[static_cast<std::size_t>(i)][0].parameterization.back();
    return std::vector<Polygon>{rectangle(0, 0, corner.x(), corner.y())};
  });
  return stack;
}

Toolpath planLifted(const Stack& stack, const PlanSettings& settings) {
  NoProgress progress;
  Toolpath toolpath = planPart("stack", stack.layers, settings,
                               {chartLift(stack.charts, stack.highest_mm, {}, settings.travel)}, progress)
                          .toolpath;
  validate(toolpath);
  return toolpath;
}

PlanSettings filledBy(const std::string& strategy) {
  PlanSettings settings;
  settings.infill.strategy = strategy;
  settings.infill.density = 1.0;
  settings.walls.count = 0;
  return settings;
}

/// The surface that the nozzle tips run on.
Mesh tipsOf(const LayerChart& chart) { return {chart.surface.tip, chart.surface.middle.triangles}; }

TEST(LiftedLayers, OfEveryStrategyLieOnTheirSurface) {
  const Stack stack = halfCylinders(2);
  for (const std::string& strategy : infillStrategyNames()) {
    if (strategy == "vase") continue;
    const Toolpath toolpath = planLifted(stack, filledBy(strategy));
    for (std::size_t i = 0; i < stack.layers.size(); ++i) {
      const Mesh tips = tipsOf(stack.charts[i][0]);
      const NearestTriangle surface(tips);
      std::size_t runs = 0;
      for (const Path& path : toolpath.layers[i].paths) {
        if (path.role == PathRole::Travel) continue;
        ++runs;
        // A chained layer begins where the one below ended. Then it begins and ends somewhere on motions.
        const bool is_chained = infillStrategy(strategy).link == LayerLink::Chained;
        const std::size_t begin = is_chained ? 2 : 0;
        const std::size_t end = path.points.size() - (is_chained ? 1 : 0);
        for (std::size_t k = begin; k < end; ++k)
          ASSERT_LE(surface.nearest(path.points[k]).distance_mm, 1e-6) << strategy;
        for (std::size_t k = is_chained ? 1 : 0; k < path.points.size(); ++k)
          ASSERT_LE(surface.nearest(path.points[k]).distance_mm, LiftSettings().position_tolerance_mm)
              << strategy;
      }
      EXPECT_GE(runs, 1U) << strategy;
    }
  }
}

TEST(LiftedLayers, HoldAsMuchAsTheirPlans) {
  const Stack stack = halfCylinders(3);
  NoProgress progress;
  for (const char* strategy : {"zigzag", "hilbert", "perimeters"}) {
    PlanSettings settings = filledBy(strategy);
    settings.skirt.count = 0;
    const double planned = totals(planToolpath("plan", stack.layers, settings, progress)).deposited_mm3;
    EXPECT_NEAR(totals(planLifted(stack, settings)).deposited_mm3, planned, 1e-6 * planned) << strategy;
  }
}

TEST(LiftedLayers, KeepTheirWallsAPitchApart) {
  const Stack stack = halfCylinders(2);
  PlanSettings settings;
  settings.infill.density = 0.0;
  const Toolpath toolpath = planLifted(stack, settings);
  for (std::size_t i = 0; i < 2; ++i) {
    const Path* outer = nullptr;
    const Path* inner = nullptr;
    for (const Path& path : toolpath.layers[i].paths) {
      if (path.role == PathRole::OuterWall) outer = &path;
      if (path.role == PathRole::InnerWall) inner = &path;
    }
    ASSERT_TRUE(outer != nullptr && inner != nullptr);
    EXPECT_TRUE(outer->is_closed);
    const test::Spacing spacing = test::spacingBetween(*inner, *outer);
    const double radius = 5.1 + test::kLayerHeight * static_cast<double>(i);
    EXPECT_NEAR(spacing.least_mm, test::kLayerPitch, 1e-3);
    EXPECT_NEAR(spacing.greatest_mm, test::kLayerPitch * (radius + 0.1) / radius, 1e-3);
  }
}

TEST(LiftedLayers, OnALevelChartAreWhatThePlanIs) {
  Stack stack;
  for (int i = 0; i < 3; ++i) {
    LayerChart chart = test::levelChart(20.0, 40);
    for (std::vector<Point3>* points : {&chart.surface.middle.vertices, &chart.surface.tip})
      for (Point3& point : *points) point.z() += test::kLayerHeight * (i + 0.5);
    stack.add(chart);
  }
  stack.layers = layersOf(3, [](int) {
    return std::vector<Polygon>{rectangle(0.5, 0.5, 19.5, 19.5), test::reversed(rectangle(5, 6, 12, 13))};
  });
  PlanSettings settings;
  settings.skirt.count = 0;
  for (const char* strategy : {"zigzag", "contour"}) {
    settings.infill.strategy = strategy;
    const Toolpath plan = test::plan(stack.layers, settings);
    const Toolpath lifted = planLifted(stack, settings);
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_EQ(lifted.layers[i].paths.size(), plan.layers[i].paths.size()) << strategy;
      for (std::size_t k = 0; k < plan.layers[i].paths.size(); ++k) {
        Path of_plan = plan.layers[i].paths[k];
        const double volume = depositedVolume(of_plan);
        // Motions without length are not lifted.
        of_plan.points.erase(
            std::unique(of_plan.points.begin(), of_plan.points.end(),
                        [](const Point3& a, const Point3& b) { return (a - b).norm() < 1e-9; }),
            of_plan.points.end());
        const Path& path = lifted.layers[i].paths[k];
        ASSERT_EQ(path.points.size(), of_plan.points.size()) << strategy << ", layer " << i << ", path " << k;
        for (std::size_t p = 0; p < path.points.size(); ++p)
          EXPECT_NEAR((path.points[p] - of_plan.points[p]).norm(), 0.0, 1e-9);
        EXPECT_EQ(path.role, of_plan.role);
        EXPECT_EQ(path.process.is_retracted, of_plan.process.is_retracted);
        ASSERT_TRUE(path.orientation.isCommon());
        EXPECT_EQ(path.orientation.at(0).coeffs(), nozzleDown().coeffs());
        EXPECT_NEAR(depositedVolume(path), volume, 1e-9);
      }
    }
  }
}

TEST(LiftedLayers, WithoutChartsStayWhereTheyArePlanned) {
  Stack stack = halfCylinders(2);
  stack.charts[0].clear();
  const Toolpath toolpath = planLifted(stack, filledBy("zigzag"));
  ASSERT_FALSE(toolpath.layers[0].paths.empty());
  for (const Path& path : toolpath.layers[0].paths)
    for (const Point3& point : path.points) EXPECT_GE(point.z(), test::kLayerHeight);
  for (const Path& path : toolpath.layers[0].paths)
    if (path.role != PathRole::Travel) {
      EXPECT_EQ(path.points.front().z(), test::kLayerHeight);
    }
}

TEST(LiftedLayers, AreChainedToOnePathInSpace) {
  const Stack stack = halfCylinders(8);
  PlanSettings settings = filledBy("contour");
  const Toolpath toolpath = planLifted(stack, settings);
  EXPECT_EQ(totals(toolpath).travel_mm, 0.0);
  for (std::size_t i = 1; i < stack.layers.size(); ++i) {
    ASSERT_EQ(toolpath.layers[i].paths.size(), 1U) << i;
    const Path& path = toolpath.layers[i].paths.front();
    EXPECT_EQ(path.firstPoint(), toolpath.layers[i - 1].paths.back().lastPoint()) << i;
    // Across at most a pitch, and up by the height.
    EXPECT_LE((path.points[1] - path.points[0]).norm(), std::hypot(test::kLayerPitch, 0.21)) << i;
  }
}

TEST(LiftedLayers, AreReachedOverAllThatIsDeposited) {
  const Stack stack = halfCylinders(3);
  PlanSettings settings = filledBy("zigzag");
  settings.walls.count = 2;
  settings.infill.density = 0.3;
  const Toolpath toolpath = planLifted(stack, settings);
  for (std::size_t i = 0; i < 3; ++i) {
    const double highest = 5.2 + test::kLayerHeight * static_cast<double>(i);
    for (const Path& path : toolpath.layers[i].paths) {
      if (path.role != PathRole::Travel || !path.process.is_retracted) continue;
      double z = 0.0;
      for (const Point3& point : path.points) z = std::max(z, point.z());
      EXPECT_GE(z, highest);
    }
  }
}

TEST(LiftedLayers, TurnTheNozzleWithoutJumps) {
  const Stack stack = halfCylinders(3);
  for (const char* strategy : {"zigzag", "contour"}) {
    const Eigen::Quaterniond* before = nullptr;
    const Toolpath toolpath = planLifted(stack, filledBy(strategy));
    for (const ToolpathLayer& layer : toolpath.layers)
      for (const Path& path : layer.paths)
        for (std::size_t i = 0; i < path.points.size(); ++i) {
          const Eigen::Quaterniond& now = path.orientation.at(i);
          if (before != nullptr && path.role != PathRole::Travel && i > 0) {
            EXPECT_LE(before->angularDistance(now), 2.0 * M_PI / kLiftedLayersSides) << strategy;
          }
          before = &now;
        }
  }
}

TEST(LiftedLayers, HaveNoSkirt) {
  PlanSettings settings = filledBy("zigzag");
  settings.skirt.count = 3;
  const Toolpath toolpath = planLifted(halfCylinders(1), settings);
  ASSERT_FALSE(toolpath.layers[0].paths.empty());
  for (const Path& path : toolpath.layers[0].paths) EXPECT_NE(path.role, PathRole::Skirt);
}

TEST(LiftedLayers, CannotRiseInAVase) {
  EXPECT_THROW(planLifted(halfCylinders(2), filledBy("vase")), InvalidConfig);
}

}  // namespace
}  // namespace lamina
