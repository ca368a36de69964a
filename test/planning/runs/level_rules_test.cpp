// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/settings_schema.hpp"
#include "lamina/planning/runs/runs.hpp"

namespace lamina {
namespace {

constexpr double kSteelSection = 8.0 + M_PI;  // mm2: a bead of 6 x 2 mm

Path ruledBead(std::vector<Point3> points, PathRole role = PathRole::OuterWall) {
  Path path;
  path.role = role;
  path.points = std::move(points);
  path.bead = Bead{6.0, 2.0};
  path.feed_mm_s = 8.0;
  return path;
}

/// A wall and an infill of 40 mm in each of the layers, with travels between.
Toolpath ruledLayers(std::size_t count) {
  Toolpath toolpath;
  for (std::size_t l = 0; l < count; ++l) {
    const double z_mm = 2.0 * static_cast<double>(l + 1);
    const Point3 begin(0, 0, z_mm);
    const Point3 end(40, 0, z_mm);
    Path travel;
    travel.role = PathRole::Travel;
    travel.points = {end, begin};
    travel.feed_mm_s = 100.0;
    toolpath.layers.push_back(
        {z_mm, 2.0, {ruledBead({begin, end}), travel, ruledBead({begin, end}, PathRole::Infill)}});
  }
  return toolpath;
}

Toolpath oneBead(std::vector<Point3> points, const LevelSettings& settings) {
  Toolpath toolpath;
  toolpath.layers = {{2.0, 2.0, {ruledBead(std::move(points))}}};
  stateLevels(toolpath, settings);
  validate(toolpath);
  return toolpath;
}

LevelSettings laser(SettingTable rules, SettingTable channels = {}) {
  LevelSettings settings;
  settings.values = "laser_power_w=1200";
  settings.rules = std::move(rules);
  settings.channels = std::move(channels);
  return settings;
}

/// Of the wall (0) or the infill (2) of a layer.
double levelIn(const LevelSettings& settings, std::size_t layer, std::size_t path) {
  Toolpath toolpath = ruledLayers(layer + 1);
  stateLevels(toolpath, settings);
  return toolpath.layers[layer].paths[path].values.front().value.at(1);
}

std::string levelRefusal(const LevelSettings& levels) {
  BeadRunSettings settings;
  settings.levels = levels;
  try {
    requireConsistent(settings);
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return "";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(LevelRules, ApplyToARole) {
  const LevelSettings settings = laser({{"0.when.role", "outer_wall"}, {"0.set.laser_power_w", "1000"}});
  EXPECT_EQ(levelIn(settings, 0, 0), 1000.0);
  EXPECT_EQ(levelIn(settings, 0, 2), 1200.0);
}

TEST(LevelRules, ApplyToLayersAndHeightsWithTheirEnds) {
  const LevelSettings layers = laser({{"0.when.layers", "0,2"}, {"0.set.laser_power_w", "1500"}});
  EXPECT_EQ(levelIn(layers, 2, 0), 1500.0);
  EXPECT_EQ(levelIn(layers, 3, 0), 1200.0);
  const LevelSettings heights = laser({{"0.when.z_mm", "4,6"}, {"0.scale.laser_power_w", "0.5"}});
  EXPECT_EQ(levelIn(heights, 0, 0), 1200.0);
  EXPECT_EQ(levelIn(heights, 1, 0), 600.0);
  EXPECT_EQ(levelIn(heights, 2, 0), 600.0);
}

TEST(LevelRules, LaterOnesWin) {
  const LevelSettings settings = laser({{"0.when.layers", "0,0"},
                                        {"0.set.laser_power_w", "1500"},
                                        {"1.when.role", "outer_wall"},
                                        {"1.set.laser_power_w", "1000"},
                                        {"2.when.always", "true"},
                                        {"2.scale.laser_power_w", "1.1"}});
  EXPECT_NEAR(levelIn(settings, 0, 0), 1100.0, 1e-9);
  EXPECT_NEAR(levelIn(settings, 0, 2), 1650.0, 1e-9);
}

TEST(LevelRules, ScaleNearCorners) {
  const LevelSettings settings = laser({{"0.when.corner_mm", "3"}, {"0.scale.laser_power_w", "0.85"}});
  // A bend of 90 deg at 20 mm, and one of 45 deg, which is no corner.
  const Toolpath bent = oneBead({{0, 0, 2}, {20, 0, 2}, {20, 20, 2}, {10, 30, 2}}, settings);
  const Path& path = bent.layers[0].paths[0];
  ASSERT_EQ(path.points.size(), 6U);
  EXPECT_LT((path.points[1] - Point3(17, 0, 2)).norm(), 1e-9);
  EXPECT_LT((path.points[3] - Point3(20, 3, 2)).norm(), 1e-9);
  const AlongPath<double>& value = path.values[0].value;
  EXPECT_EQ(value.at(1), 1200.0);
  EXPECT_NEAR(value.at(2), 1020.0, 1e-9);
  EXPECT_NEAR(value.at(3), 1020.0, 1e-9);
  EXPECT_EQ(value.at(4), 1200.0);
  EXPECT_EQ(value.at(5), 1200.0);
}

TEST(LevelRules, FindTheCornerAtTheStartOfARing) {
  const LevelSettings settings = laser({{"0.when.corner_mm", "3"}, {"0.scale.laser_power_w", "0.5"}});
  Toolpath toolpath;
  toolpath.layers = {{2.0, 2.0, {ruledBead({{0, 0, 2}, {20, 0, 2}, {20, 20, 2}, {0, 20, 2}})}}};
  toolpath.layers[0].paths[0].is_closed = true;
  stateLevels(toolpath, settings);
  const Path& path = toolpath.layers[0].paths[0];
  ASSERT_EQ(path.points.size(), 12U);
  EXPECT_EQ(path.values[0].value.at(1), 600.0);   // to (3, 0)
  EXPECT_EQ(path.values[0].value.at(2), 1200.0);  // to (17, 0)
  EXPECT_EQ(path.values[0].value.at(11), 1200.0);
  EXPECT_EQ(path.values[0].value.at(0), 600.0);  // back to the start
}

TEST(LevelLaws, FollowFeedAndSection) {
  SettingTable rules = {
      {"0.when.always", "true"}, {"0.law.laser_power_w", "per_length_j_mm"}, {"0.law.value", "120"}};
  EXPECT_NEAR(levelIn(laser(rules), 0, 0), 960.0, 1e-9);  // W: 120 J/mm at 8 mm/s
  rules["0.law.laser_power_w"] = "per_volume_j_mm3";
  rules["0.law.value"] = "10";
  EXPECT_NEAR(levelIn(laser(rules), 0, 0), 10.0 * kSteelSection * 8.0, 1e-9);
}

TEST(LevelLaws, FollowTablesAndApproachAValue) {
  const SettingTable table = {{"0.when.always", "true"},
                              {"0.law.laser_power_w", "table"},
                              {"0.law.over", "layer"},
                              {"0.law.points.1", "1500"},
                              {"0.law.points.3", "1100"}};
  EXPECT_EQ(levelIn(laser(table), 0, 0), 1500.0);
  EXPECT_NEAR(levelIn(laser(table), 2, 0), 1300.0, 1e-9);
  EXPECT_EQ(levelIn(laser(table), 4, 0), 1100.0);
  const SettingTable approach = {{"0.when.always", "true"},
                                 {"0.law.laser_power_w", "approach"},
                                 {"0.law.first", "1500"},
                                 {"0.law.last", "1000"},
                                 {"0.law.layers", "2"}};
  EXPECT_NEAR(levelIn(laser(approach), 0, 0), 1500.0, 1e-9);
  EXPECT_NEAR(levelIn(laser(approach), 2, 0), 1183.94, 0.01);  // W: 1000 + 500 / e
}

TEST(LevelChannels, GivePowderByTheBead) {
  LevelSettings settings;
  settings.values = "powder_g_min=from_bead";
  EXPECT_TRUE(holds(levelRefusal(settings), "levels.channels.powder_g_min.density_g_cm3 is missing"));
  settings.channels = {{"powder_g_min.density_g_cm3", "7.99"}, {"powder_g_min.efficiency", "0.8"}};
  Toolpath toolpath = ruledLayers(1);
  for (Path& path : toolpath.layers[0].paths)
    if (path.role != PathRole::Travel) {
      path.bead = Bead{1.2, 0.4};
      path.feed_mm_s = 10.0;
    }
  stateLevels(toolpath, settings);
  EXPECT_NEAR(toolpath.layers[0].paths[0].values[0].value.at(1), 2.671, 0.001);
}

TEST(LevelChannels, HaveEndsOfTheirOwn) {
  LevelSettings settings = laser({}, {{"laser_power_w.start_share", "0.6"},
                                      {"laser_power_w.start_mm", "8"},
                                      {"laser_power_w.start_hold_s", "0.5"}});
  settings.values += ", wire_speed_mm_s=from_bead";
  const Toolpath toolpath = oneBead({{0, 0, 2}, {40, 0, 2}}, settings);
  const Path& path = toolpath.layers[0].paths[0];
  ASSERT_EQ(path.points.size(), 11U);  // 4 mm held at 8 mm/s, eight steps of 1 mm, and 40 mm
  EXPECT_NEAR(path.points[1].x(), 4.0, 1e-9);
  EXPECT_NEAR(path.values[0].value.at(1), 720.0, 1e-9);
  EXPECT_NEAR(path.values[0].value.at(2), 1200.0 * (0.6 + 0.4 * 0.5 / 8.0), 1e-9);
  EXPECT_NEAR(path.values[0].value.at(10), 1200.0, 1e-9);
  for (const double wire_mm_s : path.values[1].value.values()) EXPECT_NEAR(wire_mm_s, 78.81, 0.01);
}

TEST(LevelChannels, LeadByTheirDeadTime) {
  const LevelSettings settings = laser({{"0.when.corner_mm", "3"}, {"0.scale.laser_power_w", "0.5"}},
                                       {{"laser_power_w.dead_time_s", "0.5"}});
  const Toolpath toolpath = oneBead({{0, 0, 2}, {20, 0, 2}, {20, 20, 2}}, settings);
  const Path& path = toolpath.layers[0].paths[0];
  // From 17 to 23 mm without dead time: 4 mm earlier at 8 mm/s, from 13 to 19 mm.
  double way_mm = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const double length_mm = (path.points[i] - path.points[i - 1]).norm();
    const double middle_mm = way_mm + 0.5 * length_mm;
    EXPECT_EQ(path.values[0].value.at(i), middle_mm > 13.0 && middle_mm < 19.0 ? 600.0 : 1200.0) << middle_mm;
    way_mm += length_mm;
  }
  EXPECT_LT((path.points[1] - Point3(13, 0, 2)).norm(), 1e-6);
}

TEST(LevelChannels, LeadOverTravelsToTheNextRun) {
  const LevelSettings settings = laser({{"0.when.role", "infill"}, {"0.set.laser_power_w", "600"}},
                                       {{"laser_power_w.dead_time_s", "1"}});
  Toolpath toolpath = ruledLayers(1);
  stateLevels(toolpath, settings);
  // The travel takes 0.4 s: the wall has the power of the infill in its last 0.6 s, 4.8 mm.
  const Path& wall = toolpath.layers[0].paths[0];
  ASSERT_EQ(wall.points.size(), 3U);
  EXPECT_NEAR(wall.points[1].x(), 35.2, 1e-6);
  EXPECT_EQ(wall.values[0].value.at(1), 1200.0);
  EXPECT_EQ(wall.values[0].value.at(2), 600.0);
  EXPECT_TRUE(toolpath.layers[0].paths[1].values.empty());
  EXPECT_EQ(toolpath.layers[0].paths[2].values[0].value.at(1), 600.0);
}

TEST(LevelChannels, RefuseWhatIsOutOfBounds) {
  const LevelSettings settings = laser({{"0.when.layers", "1,1"}, {"0.set.laser_power_w", "4200"}},
                                       {{"laser_power_w.lower", "100"}, {"laser_power_w.upper", "4000"}});
  EXPECT_EQ(levelIn(settings, 0, 0), 1200.0);
  try {
    levelIn(settings, 1, 0);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(
        error.what(),
        "layer 1 at 4 mm, path 0, waypoint 1: laser_power_w is 4200 W by levels.rules 0; expected 100 W "
        "to 4000 W, as levels.channels.laser_power_w states");
  }
}

TEST(LevelRules, AreReadFromSettingsAsAList) {
  BeadRunSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  schema.set("levels.values", "laser_power_w=1200");
  schema.set("levels.channels", "{laser_power_w: {lower: 100, upper: 4000}}");
  schema.set(
      "levels.rules",
      "[{when: {role: outer_wall, layers: [0, 2]}, set: {laser_power_w: 1000}}, {when: {always: true}, "
      "law: {laser_power_w: table, over: z_mm, points: {0.5: 1500, 4.5: 1100}}}]");
  requireConsistent(settings);
  EXPECT_NEAR(levelIn(settings.levels, 0, 0), 1350.0, 1e-9);  // at 2 mm
  schema.set("levels.channels.laser_power_w.upper", "1300");
  EXPECT_THROW(levelIn(settings.levels, 0, 0), InvalidInput);
}

TEST(LevelRules, AreRefusedByNumberAndKey) {
  const auto refusedWith = [](const SettingTable& rules, const std::string& part) {
    const std::string refusal = levelRefusal(laser(rules));
    EXPECT_TRUE(holds(refusal, "levels.rules 0: ") && holds(refusal, part)) << refusal;
  };
  refusedWith({{"0.set.laser_power_w", "1"}}, "there is no other condition");
  refusedWith({{"0.when.always", "true"}}, "nothing is changed");
  refusedWith({{"0.when.always", "true"}, {"0.set.gas_l_min", "1"}}, "gas_l_min is changed but not stated");
  refusedWith({{"0.when.always", "true"}, {"0.set.laser_power_w", "from_bead"}}, "only wire_speed_mm_s");
  refusedWith({{"0.when.always", "true"}, {"0.law.laser_power_w", "per_length_j_mm"}},
              "law.value is missing");
  refusedWith({{"0.when.always", "true"}, {"0.law.laser_power_w", "square"}}, "'square'");
  refusedWith({{"0.when.role", "roof"}, {"0.set.laser_power_w", "1"}}, "roof");
  refusedWith({{"0.when.layers", "3,1"}, {"0.set.laser_power_w", "1"}}, "when.layers is 3, 1");
  EXPECT_TRUE(
      holds(levelRefusal(laser({}, {{"gas_l_min.upper", "3"}})), "levels.channels holds 'gas_l_min'"));
}

TEST(LevelRules, OfCornersAreRefusedInWeaves) {
  BeadRunSettings settings;
  settings.levels = laser({{"0.when.corner_mm", "3"}, {"0.scale.laser_power_w", "0.85"}});
  requireConsistent(settings);
  settings.weave.kind = WeaveKind::Sine;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
}

TEST(LevelChannels, BringTheWholeSectionOverAClosingOverlap) {
  Path ring = ruledBead({});
  for (int i = 0; i < 360; ++i)
    ring.points.emplace_back(50.0 * std::cos(i * M_PI / 180.0), 50.0 * std::sin(i * M_PI / 180.0), 2.0);
  ring.is_closed = true;
  Toolpath toolpath;
  toolpath.layers = {{2.0, 2.0, {ring}}};
  LeadSettings lead;
  lead.overlap_mm = 10.0;
  overlapEnds(toolpath, lead);
  LevelSettings settings;
  settings.values = "wire_speed_mm_s=from_bead";
  stateLevels(toolpath, settings);
  const Path& path = toolpath.layers[0].paths[0];
  const double wire_mm2 = 0.25 * M_PI * 1.2 * 1.2;
  std::vector<double> sections(110, 0.0);  // mm2, each 0.1 mm from the start
  double way_mm = 0.0;
  const double round_mm = length(ring);
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const double end_mm = way_mm + (path.points[i] - path.points[i - 1]).norm();
    const double section_mm2 = path.values[0].value.at(i) * wire_mm2 / path.feed_mm_s.at(i);
    for (std::size_t s = 0; s < sections.size(); ++s)
      for (const double at_mm :
           {0.1 * static_cast<double>(s) + 0.03, 0.1 * static_cast<double>(s) + 0.03 + round_mm})
        if (at_mm > way_mm && at_mm <= end_mm) sections[s] += section_mm2;
    way_mm = end_mm;
  }
  for (const double section_mm2 : sections) EXPECT_NEAR(section_mm2, kSteelSection, 0.02 * kSteelSection);
}

}  // namespace
}  // namespace lamina
