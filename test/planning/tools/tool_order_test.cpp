// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Tools by role, their order in layers, and the prime tower.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/planning/planner.hpp"

namespace lamina {
namespace {

constexpr std::size_t kToolLayers = 6;

/// A square prism of 20 mm in layers of 0.2 mm.
std::vector<Layer> squareLayers() {
  std::vector<Layer> layers;
  for (std::size_t i = 0; i < kToolLayers; ++i) {
    Layer layer;
    layer.bounds = {0.2 * static_cast<double>(i), 0.2 * static_cast<double>(i + 1)};
    layer.section.contours = {{{0, 0}, {20, 0}, {20, 20}, {0, 20}}};
    layers.push_back(layer);
  }
  return layers;
}

PlanSettings twoTools() {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.tools.list = {{"0.name", "black"}, {"1.name", "white"}, {"2.name", "soluble"}};
  settings.tools.infill = 1;
  return settings;
}

Toolpath plannedByTools(const PlanSettings& settings) {
  NoProgress nobody;
  Toolpath toolpath = planToolpath("prism", squareLayers(), settings, nobody);
  validate(toolpath);
  return toolpath;
}

/// The tools of all paths, each as often as it is taken.
std::vector<std::uint32_t> takenTools(const Toolpath& toolpath) {
  std::vector<std::uint32_t> taken;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (taken.empty() || taken.back() != path.tool) taken.push_back(path.tool);
  return taken;
}

std::map<PathRole, double> volumes(const Toolpath& toolpath) {
  std::map<PathRole, double> sums;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel) sums[path.role] += depositedVolume(path);
  return sums;
}

TEST(Tools, ChangeOncePerLayerThatHasTwo) {
  const Toolpath toolpath = plannedByTools(twoTools());
  EXPECT_EQ(takenTools(toolpath), (std::vector<std::uint32_t>{0, 1, 0, 1, 0, 1, 0}));
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel) {
        EXPECT_EQ(path.tool, path.role == PathRole::Infill ? 1U : 0U);
      }
}

TEST(Tools, LayWhatOneToolLays) {
  PlanSettings one = twoTools();
  one.tools = {};
  EXPECT_EQ(volumes(plannedByTools(twoTools())), volumes(plannedByTools(one)));
}

TEST(Tools, ChangeOnARetractedTravelOfTheNewTool) {
  const Toolpath toolpath = plannedByTools(twoTools());
  std::size_t changes = 0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (std::size_t p = 1; p < layer.paths.size(); ++p)
      if (layer.paths[p].tool != layer.paths[p - 1].tool) {
        ++changes;
        EXPECT_EQ(layer.paths[p].role, PathRole::Travel);
        EXPECT_TRUE(layer.paths[p].process.is_retracted);
      }
  EXPECT_EQ(changes, kToolLayers);
}

TEST(Tools, AreNotChangedByDefault) {
  PlanSettings listed = twoTools();
  listed.tools.infill = 0;
  listed.tools.purge_mm3 = {100.0};
  PlanSettings none = listed;
  none.tools = {};
  EXPECT_EQ(toolpathId(plannedByTools(listed)), toolpathId(plannedByTools(none)));
}

TEST(Tools, OfSupportsAreThoseThatTheyName) {
  PlanSettings settings = twoTools();
  settings.supports.use = true;
  settings.supports.interface_tool = 2;
  NoProgress nobody;
  // A table of 20 mm on a foot of 6 mm.
  std::vector<Layer> layers = squareLayers();
  for (std::size_t i = 0; i < 4; ++i) layers[i].section.contours = {{{7, 7}, {13, 7}, {13, 13}, {7, 13}}};
  std::set<std::uint32_t> of_interfaces;
  for (const ToolpathLayer& layer : planToolpath("table", layers, settings, nobody).layers)
    for (const Path& path : layer.paths)
      if (path.role == PathRole::SupportInterface) of_interfaces.insert(path.tool);
  EXPECT_EQ(of_interfaces, (std::set<std::uint32_t>{2}));
  settings.supports.interface_tool = 3;
  EXPECT_THROW(planToolpath("table", layers, settings, nobody), InvalidConfig);
}

/// What is primed between a change of tools and the first bead of the part [mm³], layer by layer.
std::vector<double> purgedVolumes(const Toolpath& toolpath) {
  std::vector<double> sums;
  for (const ToolpathLayer& layer : toolpath.layers) {
    double sum = 0.0;
    for (const Path& path : layer.paths)
      if (path.role == PathRole::Prime) sum += depositedVolume(path);
    sums.push_back(sum);
  }
  return sums;
}

TEST(PrimeTowers, HoldTheVolumeOfEachChange) {
  for (const double volume_mm3 : {10.0, 37.0, 100.0}) {
    PlanSettings settings = twoTools();
    settings.tools.purge_mm3 = {volume_mm3};
    const Toolpath toolpath = plannedByTools(settings);
    for (const double purged : purgedVolumes(toolpath)) EXPECT_NEAR(purged, volume_mm3, 0.01 * volume_mm3);
    for (const ToolpathLayer& layer : toolpath.layers) {
      // The new tool lays into the tower first.
      const std::uint32_t first = layer.paths.front().tool;
      const auto taken = std::find_if(layer.paths.begin(), layer.paths.end(), [&](const Path& path) {
        return path.tool != first && path.role != PathRole::Travel;
      });
      ASSERT_NE(taken, layer.paths.end());
      EXPECT_EQ(taken->role, PathRole::Prime);
    }
  }
}

TEST(PrimeTowers, StandBesideThePartAndTurnTheirLines) {
  PlanSettings settings = twoTools();
  settings.tools.purge_mm3 = {100.0};
  Box2 tower;
  for (const ToolpathLayer& layer : plannedByTools(settings).layers)
    for (const Path& path : layer.paths)
      if (path.role == PathRole::Prime)
        for (const Point3& point : path.points) tower.include(point.head<2>());
  // 100 mm³ in a layer of 0.2 mm are 500 mm² or more.
  EXPECT_GT(tower.size().x(), 22.0);
  EXPECT_LT(tower.size().x(), 25.0);
  EXPECT_NEAR(tower.size().x(), tower.size().y(), 1e-9);
  EXPECT_GT(tower.low.x(), 20.0 + 4.0);
  EXPECT_NEAR(tower.low.y() + tower.high.y(), 20.0, 1e-9);
}

TEST(PrimeTowers, TakeVolumesFromToolToTool) {
  PlanSettings settings = twoTools();
  settings.tools.list.erase("2.name");
  settings.tools.purge_mm3 = {0.0, 60.0, 20.0, 0.0};
  const std::vector<double> purged = purgedVolumes(plannedByTools(settings));
  for (std::size_t l = 0; l < purged.size(); ++l)
    EXPECT_NEAR(purged[l], l % 2 == 0 ? 60.0 : 20.0, 0.5) << l;  // 0 to 1, and back in the next layer
}

TEST(PrimeTowers, StayAsHighAsThePartWhereNoToolChanges) {
  PlanSettings settings = twoTools();
  settings.tools.infill = 0;
  settings.tools.skin = 1;
  settings.skins.top_layers = 1;
  settings.tools.purge_mm3 = {50.0};
  const std::vector<double> purged = purgedVolumes(plannedByTools(settings));
  for (std::size_t l = 0; l + 1 < purged.size(); ++l) {
    EXPECT_GT(purged[l], 5.0);
    EXPECT_LT(purged[l], 25.0);
  }
  EXPECT_NEAR(purged.back(), 50.0, 0.5);
}

TEST(PrimeTowers, RefuseWhatCannotBe) {
  NoProgress nobody;
  const auto refused = [&](const PlanSettings& settings) {
    EXPECT_THROW(planToolpath("prism", squareLayers(), settings, nobody), InvalidConfig);
  };
  PlanSettings settings = twoTools();
  settings.tools.purge_mm3 = {100.0};
  settings.tools.tower_mm = 15.0;
  refused(settings);
  settings.tools.tower_mm = 0.0;
  settings.tools.tower_at_mm = {15.0, 10.0};
  refused(settings);
  settings = twoTools();
  settings.tools.infill = 3;
  refused(settings);
  settings = twoTools();
  settings.tools.purge_mm3 = {1.0, 2.0, 3.0};
  refused(settings);
  settings = twoTools();
  settings.infill.strategy = "vase";
  refused(settings);
  settings = twoTools();
  settings.tools.purge_mm3 = {100.0};
  LayerIncline incline;
  EXPECT_THROW(planPart("prism", squareLayers(), settings, incline, nobody), InvalidConfig);
}

}  // namespace
}  // namespace lamina
