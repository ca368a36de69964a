// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/planner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/infill/strategy.hpp"
#include "support/planned_layers.hpp"
#include "support/scoped_entry.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::plan;
using test::rectangle;
using test::reversed;

/// Layers of the same section, 0.2 mm high.
std::vector<Layer> prism(const std::vector<Polygon>& contours, int count) {
  return test::layersOf(count, [&](int) { return contours; });
}

PlanSettings plainSettings() {
  PlanSettings settings;
  settings.skirt.count = 0;
  return settings;
}

double lengthOf(const Toolpath& toolpath, PathRole role) {
  double sum = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role == role) sum += length(path);
  return sum;
}

TEST(Planner, LaysTheWallsOfASquareHalfABeadAndThenAPitchInside) {
  const Toolpath toolpath = plan(prism({rectangle(0, 0, 20, 20)}, 1), plainSettings());
  EXPECT_NEAR(lengthOf(toolpath, PathRole::OuterWall), 4 * 19.6, 1e-3);
  // A bead of 0.4 x 0.2 mm fills (0.2 * 0.2 + pi * 0.01) / 0.2 mm.
  EXPECT_NEAR(lengthOf(toolpath, PathRole::InnerWall), 4 * (19.6 - 2 * (0.2 + 0.05 * M_PI)), 1e-3);
}

/// Runs of that role that are shorter.
int shorterRuns(const Toolpath& toolpath, PathRole role, double length_mm) {
  int count = 0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role == role && length(path) < length_mm) ++count;
  return count;
}

/// A dome with waves round it, whose layers end in skins that divide the infill.
std::vector<Layer> wavyDome(int count) {
  return test::layersOf(count, [&](int i) {
    const double radius = 15.0 * std::sqrt(1.0 - std::pow(static_cast<double>(i) / count, 2.0));
    Polygon outline;
    for (int k = 0; k < 180; ++k) {
      const double phi = k * M_PI / 90.0;
      const double r = radius * (1.0 + 0.1 * std::cos(5.0 * phi) + 0.05 * std::cos(13.0 * phi + 0.05 * i));
      outline.emplace_back(r * std::cos(phi), r * std::sin(phi));
    }
    return std::vector<Polygon>{outline};
  });
}

TEST(Planner, DoesNotTravelToDotsInsideThePart) {
  PlanSettings settings = plainSettings();
  settings.infill.density = 0.2;
  settings.skins.top_layers = settings.skins.bottom_layers = 4;
  const Toolpath toolpath = plan(wavyDome(60), settings);
  EXPECT_GT(lengthOf(toolpath, PathRole::Infill), 0.0);
  EXPECT_GT(lengthOf(toolpath, PathRole::Skin), 0.0);
  EXPECT_EQ(shorterRuns(toolpath, PathRole::Infill, 0.8), 0);
  EXPECT_EQ(shorterRuns(toolpath, PathRole::InnerWall, 0.4), 0);
  EXPECT_EQ(shorterRuns(toolpath, PathRole::GapFill, 0.4), 0);
  EXPECT_EQ(shorterRuns(toolpath, PathRole::Skin, 0.4), 0);
}

TEST(Planner, WithoutWallsAndInfillGivesEmptyLayers) {
  PlanSettings settings = plainSettings();
  settings.walls.count = 0;
  settings.infill.density = 0.0;
  const Toolpath toolpath = plan(prism({rectangle(0, 0, 20, 20)}, 3), settings);
  ASSERT_EQ(toolpath.layers.size(), 3U);
  for (const ToolpathLayer& layer : toolpath.layers) EXPECT_TRUE(layer.paths.empty());
}

TEST(Planner, KeepsLayersWhoseSectionIsEmpty) {
  std::vector<Layer> layers = prism({rectangle(0, 0, 20, 20)}, 3);
  layers[1].section.contours.clear();
  const Toolpath toolpath = plan(layers, plainSettings());
  EXPECT_TRUE(toolpath.layers[1].paths.empty());
  EXPECT_EQ(toolpath.layers[2].paths.front().role, PathRole::Travel);
}

TEST(Planner, RunsAtTheTopOfEachLayerWithABeadAsHighAsIt) {
  std::vector<Layer> layers = prism({rectangle(0, 0, 20, 20)}, 2);
  layers[1].bounds = {0.2, 0.5};
  const Toolpath toolpath = plan(layers, plainSettings());
  EXPECT_DOUBLE_EQ(toolpath.layers[1].z_mm, 0.5);
  const Path& last = toolpath.layers[1].paths.back();
  EXPECT_DOUBLE_EQ(last.firstPoint().z(), 0.5);
  EXPECT_DOUBLE_EQ(last.bead.at(0).height_mm, 0.3);
}

TEST(Planner, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Polygon> loop = {circle({5, 5}, 10, 90), reversed(circle({5, 5}, 5, 60))};
  const std::vector<Layer> layers = prism(loop, 40);
  std::vector<std::string> ids;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    ids.push_back(toolpathId(plan(layers, plainSettings())));
  }
  EXPECT_EQ(ids[0], ids[1]);
  EXPECT_EQ(ids[0], ids[2]);
}

TEST(Planner, RefusesAnUnknownStrategyNamingTheChoices) {
  PlanSettings settings = plainSettings();
  settings.infill.strategy = "spaghetti";
  try {
    plan(prism({rectangle(0, 0, 20, 20)}, 1), settings);
    FAIL() << "nothing thrown";
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("zigzag"), std::string::npos) << error.what();
  }
}

TEST(Planner, RefusesSettingsOutOfRange) {
  PlanSettings settings = plainSettings();
  settings.bead.width_mm = 0.0;
  EXPECT_THROW(plan(prism({rectangle(0, 0, 20, 20)}, 1), settings), InvalidConfig);
}

/// What `plan` throws where the fill of the second island of layer 1 throws.
std::string messageOfFailingFill(const FillFunction& fails) {
  InfillStrategy strategy;
  strategy.fill = [&](const Regions& regions, const InfillRequest& request) {
    return request.layer == 1 && request.island == 1 ? fails(regions, request) : std::vector<FillPath>();
  };
  const test::ScopedEntry<InfillStrategy> entry(infillStrategies(), "failing", strategy);
  PlanSettings settings = plainSettings();
  settings.infill.strategy = "failing";
  try {
    plan(prism({rectangle(0, 0, 20, 20), rectangle(30, 0, 50, 20)}, 3), settings);
  } catch (const InvalidInput& error) {
    return error.what();
  } catch (const Error& error) {
    return std::string(toString(error.code())) + " " + error.what();
  }
  return "";
}

TEST(Planner, NamesLayerAndIslandThatCannotBeFilled) {
  const FillFunction refuses = [](const Regions&, const InfillRequest&) -> std::vector<FillPath> {
    throw InvalidInput("too many dots");
  };
  EXPECT_EQ(messageOfFailingFill(refuses), "layer 1 at 0.4 mm, island 1: too many dots");
  const FillFunction breaks = [](const Regions&, const InfillRequest&) -> std::vector<FillPath> {
    throw std::out_of_range("dot 7");
  };
  EXPECT_EQ(messageOfFailingFill(breaks), "Internal layer 1 at 0.4 mm, island 1: dot 7");
}

/// Where the middle of a square's infill lies in the part, as its strategy is given it.
Point3 middleInPart(const Polygon& square, const Eigen::Quaterniond& part_from_layers) {
  Point3 middle = Point3::Zero();
  InfillStrategy strategy;
  strategy.fill = [&](const Regions& regions, const InfillRequest& request) {
    const Point2 centre = boundingBox(outlines(regions)).centre();
    middle = request.part_from_plan * Point3(centre.x(), centre.y(), 0.0);
    return std::vector<FillPath>();
  };
  const test::ScopedEntry<InfillStrategy> entry(infillStrategies(), "asking", strategy);
  PlanSettings settings = plainSettings();
  settings.infill.strategy = "asking";
  NoProgress nobody;
  planPart("part", prism({square}, 1), settings, LayerIncline{BedPlane{}, part_from_layers}, nobody);
  return middle;
}

/// Layers far out on a belt are planned near the origin, and lie in the part where they are.
TEST(Planner, SaysWhereInThePartAnInclinedLayerIsFilled) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Point3(1, 2, 0).normalized()));
  EXPECT_LT((middleInPart(rectangle(0, 0, 20, 10), turn) - turn * Point3(10, 5, 0.2)).norm(), 1e-6);
  EXPECT_LT((middleInPart(rectangle(0, 8000, 20, 8010), turn) - turn * Point3(10, 8005, 0.2)).norm(), 1e-6);
}

TEST(Planner, FillsByAStrategyThatWasAdded) {
  InfillStrategy strategy;
  strategy.fill = [](const Regions&, const InfillRequest&) {
    return std::vector<FillPath>{{{{5, 10}, {15, 10}}, false, PathRole::Infill, Deposit::Bead, {}}};
  };
  const test::ScopedEntry<InfillStrategy> entry(infillStrategies(), "one_line", strategy);
  PlanSettings settings = plainSettings();
  settings.infill.strategy = "one_line";
  EXPECT_NEAR(lengthOf(plan(prism({rectangle(0, 0, 20, 20)}, 3), settings), PathRole::Infill), 30.0, 1e-9);
}

}  // namespace
}  // namespace lamina
