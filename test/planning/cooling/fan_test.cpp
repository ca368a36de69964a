// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Shares of roles, and the fan's spin-up.
#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/planning/cooling/cooling.hpp"

namespace lamina {
namespace {

MotionLimits withoutInertia() {
  MotionLimits limits;
  limits.acceleration_mm_s2 = limits.travel_acceleration_mm_s2 = 1e9;
  return limits;
}

/// Along x at 10 mm/s.
Path stretch(PathRole role, double from_mm, double to_mm) {
  Path path;
  path.role = role;
  path.points = {{from_mm, 0, 1}, {to_mm, 0, 1}};
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 10.0;
  return path;
}

Toolpath oneLayer(std::vector<Path> paths) {
  Toolpath toolpath;
  toolpath.layers = {{1.0, 0.2, std::move(paths)}};
  return toolpath;
}

/// A layer has 0.2, a bridge 0.9.
FanSettings fanOfBridges() {
  FanSettings settings;
  settings.is_used = true;
  settings.off_layers = 0;
  settings.full_below_s = 0.0;
  settings.least_at_s = 1.0;
  settings.least = 0.2;
  settings.bridge = 0.9;
  return settings;
}

/// What the fan is commanded, and where along x [mm].
struct Commanded {
  double at_mm;
  double share;
};

std::vector<Commanded> commandedOf(Toolpath& toolpath, const FanSettings& settings) {
  const double volume = totals(toolpath).deposited_mm3;
  addFan(toolpath, settings, withoutInertia());
  validate(toolpath);
  EXPECT_NEAR(totals(toolpath).deposited_mm3, volume, 1e-9);
  std::vector<Commanded> commanded;
  for (const Path& path : toolpath.layers[0].paths)
    for (const PathEvent& each : path.events)
      commanded.push_back({path.points[each.motion].x(), std::get<FanShare>(each.event).share});
  return commanded;
}

void expectCommanded(const std::vector<Commanded>& commanded, const std::vector<Commanded>& wanted) {
  ASSERT_EQ(commanded.size(), wanted.size());
  for (std::size_t i = 0; i < commanded.size(); ++i) {
    EXPECT_NEAR(commanded[i].at_mm, wanted[i].at_mm, 0.01) << i;
    EXPECT_DOUBLE_EQ(commanded[i].share, wanted[i].share) << i;
  }
}

TEST(FanByRole, HasTheShareOfTheRoleElseThatOfTheLayer) {
  FanSettings settings = fanOfBridges();
  settings.by_role = "top_skin=0.7, support_interface = 1";
  Toolpath toolpath =
      oneLayer({stretch(PathRole::OuterWall, 0, 20), stretch(PathRole::TopSkin, 20, 40),
                stretch(PathRole::Infill, 40, 60), stretch(PathRole::SupportInterface, 60, 80)});
  expectCommanded(commandedOf(toolpath, settings), {{0, 0.2}, {20, 0.7}, {40, 0.2}, {60, 1.0}});
}

TEST(FanByRole, IsOffWithTheFirstLayers) {
  FanSettings settings = fanOfBridges();
  settings.by_role = "outer_wall=0.7";
  settings.off_layers = 1;
  Toolpath toolpath = oneLayer({stretch(PathRole::OuterWall, 0, 20)});
  expectCommanded(commandedOf(toolpath, settings), {});
}

/// Share of the fan while each layer's first path is run.
std::vector<double> fanInLayers(const Toolpath& toolpath) {
  std::vector<double> shares;
  double share = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const PathEvent& each : layer.paths.front().events) share = std::get<FanShare>(each.event).share;
    shares.push_back(share);
  }
  return shares;
}

TEST(Fan, IsOffInTheFirstLayersOfEachPartThatFollowsAnother) {
  FanSettings settings = fanOfBridges();
  settings.by_role = "outer_wall=0.7";
  settings.off_layers = 1;
  Toolpath toolpath;
  for (const double z_mm : {0.3, 0.5, 0.7, 0.2, 0.4, 0.3, 0.5})
    toolpath.layers.push_back({z_mm,
                               z_mm == 0.3 ? 0.3 : 0.2,
                               {stretch(z_mm < 0.6 ? PathRole::Infill : PathRole::OuterWall, 0, 20)}});
  addFan(toolpath, settings, withoutInertia());
  EXPECT_EQ(fanInLayers(toolpath), (std::vector<double>{0.0, 0.2, 0.7, 0.0, 0.2, 0.0, 0.2}));
  // Levels that lie lower but not on the bed belong to the part.
  toolpath.layers.resize(4);
  for (ToolpathLayer& layer : toolpath.layers) layer.paths = {stretch(PathRole::Infill, 0, 20)};
  toolpath.layers[3].z_mm = 0.6;
  addFan(toolpath, settings, withoutInertia());
  EXPECT_EQ(fanInLayers(toolpath), (std::vector<double>{0.0, 0.2, 0.2, 0.2}));
}

TEST(FanByRole, IsRefusedWhereItIsNoListOfRolesAndShares) {
  for (const char* list :
       {"top_skin", "top_skn=1", "top_skin=1.2", "top_skin=-1", "top_skin=x", "bridge=1", "travel=0"}) {
    FanSettings settings;
    settings.by_role = list;
    EXPECT_THROW(requireConsistent(settings), InvalidConfig) << list;
  }
}

TEST(FanSettingsSchema, TakesTheFormerNameOfTheTimeOfTheLeastShare) {
  FanSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  schema.set("fan.off_above_s", "25");
  EXPECT_EQ(settings.least_at_s, 25.0);
}

TEST(FanSpinUp, CommandsTheFanEarlierAlongThePath) {
  FanSettings settings = fanOfBridges();
  settings.spin_up_s = 2.0;
  Toolpath toolpath = oneLayer({stretch(PathRole::Infill, 0, 100), stretch(PathRole::Bridge, 100, 130),
                                stretch(PathRole::Infill, 130, 200)});
  expectCommanded(commandedOf(toolpath, settings), {{0, 0.2}, {80, 0.9}, {130, 0.2}});
  EXPECT_EQ(toolpath.layers[0].paths[0].points.size(), 3U) << "divided where it is commanded";
}

TEST(FanSpinUp, ReachesBackThroughSeveralPaths) {
  FanSettings settings = fanOfBridges();
  settings.spin_up_s = 2.5;
  Toolpath toolpath = oneLayer({stretch(PathRole::Infill, 0, 50), stretch(PathRole::OuterWall, 50, 60),
                                stretch(PathRole::InnerWall, 60, 70), stretch(PathRole::Bridge, 70, 100)});
  expectCommanded(commandedOf(toolpath, settings), {{0, 0.2}, {45, 0.9}});
}

TEST(FanSpinUp, BeginsWithTheToolpathAtTheEarliest) {
  FanSettings settings = fanOfBridges();
  settings.spin_up_s = 20.0;
  Toolpath toolpath = oneLayer({stretch(PathRole::Infill, 0, 50), stretch(PathRole::Bridge, 50, 70)});
  expectCommanded(commandedOf(toolpath, settings), {{0, 0.9}});
}

TEST(FanSpinUp, RunsThroughALullThatIsShorter) {
  FanSettings settings = fanOfBridges();
  settings.spin_up_s = 2.0;
  Toolpath toolpath = oneLayer({stretch(PathRole::Bridge, 0, 30), stretch(PathRole::Infill, 30, 45),
                                stretch(PathRole::Bridge, 45, 60), stretch(PathRole::Infill, 60, 100),
                                stretch(PathRole::Bridge, 100, 120)});
  expectCommanded(commandedOf(toolpath, settings), {{0, 0.9}, {60, 0.2}, {80, 0.9}});
}

TEST(FanSpinUp, KeepsTheGreaterOfTwoRisesThatAreTooLate) {
  FanSettings settings = fanOfBridges();
  settings.spin_up_s = 5.0;
  settings.by_role = "top_skin=0.6";
  Toolpath toolpath = oneLayer({stretch(PathRole::Infill, 0, 20), stretch(PathRole::Bridge, 20, 30),
                                stretch(PathRole::Infill, 30, 40), stretch(PathRole::TopSkin, 40, 60)});
  expectCommanded(commandedOf(toolpath, settings), {{0, 0.9}, {30, 0.6}});
}

TEST(FanSpinUp, KeepsAFallToMoreThanWhatFollowsTheLull) {
  FanSettings settings = fanOfBridges();
  settings.spin_up_s = 5.0;
  settings.by_role = "top_skin=0.6,skin=0.4";
  Toolpath toolpath = oneLayer({stretch(PathRole::Bridge, 0, 100), stretch(PathRole::TopSkin, 100, 120),
                                stretch(PathRole::Infill, 120, 140), stretch(PathRole::Skin, 140, 200)});
  expectCommanded(commandedOf(toolpath, settings), {{0, 0.9}, {100, 0.6}, {120, 0.4}});
}

TEST(FanSpinUp, FallsOnlyAsFarAsWhatFollowsALull) {
  FanSettings settings = fanOfBridges();
  settings.spin_up_s = 2.0;
  settings.by_role = "top_skin=0.6";
  Toolpath toolpath = oneLayer({stretch(PathRole::Bridge, 0, 30), stretch(PathRole::Infill, 30, 45),
                                stretch(PathRole::TopSkin, 45, 60)});
  expectCommanded(commandedOf(toolpath, settings), {{0, 0.9}, {30, 0.6}});
}

}  // namespace
}  // namespace lamina
