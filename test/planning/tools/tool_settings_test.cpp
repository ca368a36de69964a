// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/tools/tool_settings.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/planning/tools/tool_heating.hpp"

namespace lamina {
namespace {

ToolSettings toolsFromYaml(const std::string& yaml) {
  ToolSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& setting : settingsFromYaml(yaml, "tools.yaml"))
    schema.set(setting.key, setting.text);
  return settings;
}

TEST(ToolSettings, AreAListInYaml) {
  const std::vector<Tool> tools = toolsOf(toolsFromYaml(R"(
tools:
  list:
    - {name: black, nozzle_mm: 0.4}
    - {name: white, offset_mm: [30, -0.5, 0.1], temperature_c: 220, standby_c: 150, heat_s: 20}
)"));
  ASSERT_EQ(tools.size(), 2U);
  EXPECT_EQ(tools[0].name, "black");
  EXPECT_EQ(tools[0].nozzle_mm, 0.4);
  EXPECT_EQ(tools[1].offset_mm, Point3(30.0, -0.5, 0.1));
  EXPECT_EQ(tools[1].standby_c, 150.0);
}

TEST(ToolSettings, RefuseWhatIsNoTool) {
  for (const char* bad :
       {"tools.list.0.colour: red", "tools.list.1.name: white", "tools.list.a.name: white",
        "tools.list.0.nozzle_mm: -1", "tools.list.0: white", "tools.list.0.offset_mm: [1, 2]"})
    EXPECT_THROW(toolsOf(toolsFromYaml(bad)), InvalidConfig) << bad;
}

TEST(ToolSettings, GiveRolesTheirTools) {
  ToolSettings settings;
  settings.walls = 1;
  settings.infill = 2;
  settings.skin = 3;
  EXPECT_EQ(toolFor(PathRole::OuterWall, settings), 1U);
  EXPECT_EQ(toolFor(PathRole::Skirt, settings), 1U);
  EXPECT_EQ(toolFor(PathRole::Infill, settings), 2U);
  EXPECT_EQ(toolFor(PathRole::TopSkin, settings), 3U);
  EXPECT_EQ(toolFor(PathRole::SupportInterface, settings), 1U);
  settings.support = 4;
  EXPECT_EQ(toolFor(PathRole::Raft, settings), 4U);
  EXPECT_EQ(toolFor(PathRole::SupportInterface, settings), 4U);
  settings.interface = 5;
  EXPECT_EQ(toolFor(PathRole::SupportInterface, settings), 5U);
}

/// Two tools in turn, 10 s each.
Toolpath inTurn() {
  Toolpath toolpath;
  for (std::uint32_t i = 0; i < 4; ++i) {
    Path path;
    path.role = PathRole::Infill;
    path.bead = Bead{0.4, 0.2};
    path.feed_mm_s = 10.0;
    path.tool = i % 2;
    // Two paths of 5 s.
    const double z = 0.2 * (i + 1);
    path.points = {{0, 0, z}, {50, 0, z}};
    ToolpathLayer layer{z, 0.2, {path}};
    path.points = {{50, 0, z}, {100, 0, z}};
    layer.paths.push_back(path);
    toolpath.layers.push_back(layer);
  }
  return toolpath;
}

std::string codeBefore(const Toolpath& toolpath, std::size_t layer, std::size_t path) {
  std::string text;
  for (const PathEvent& placed : toolpath.layers[layer].paths[path].events)
    if (const auto* code = std::get_if<MachineCode>(&placed.event)) text += code->text;
  return text;
}

TEST(ToolHeating, StandsByAndHeatsAhead) {
  Toolpath toolpath = inTurn();
  std::vector<Tool> tools(2);
  tools[1].temperature_c = 220.0;
  tools[1].standby_c = 150.0;
  tools[1].heat_s = 4.0;
  MotionLimits limits;
  limits.acceleration_mm_s2 = limits.travel_acceleration_mm_s2 = 1e9;
  addToolHeating(toolpath, tools, {210.0, limits, {}});
  EXPECT_EQ(codeBefore(toolpath, 0, 0), "");
  EXPECT_EQ(codeBefore(toolpath, 0, 1), "M104 T1 S220\n");  // 5 s before it is taken
  EXPECT_EQ(codeBefore(toolpath, 1, 0), "M109 T1 S220\n");
  EXPECT_EQ(codeBefore(toolpath, 2, 0), "M104 T1 S150\n");
  EXPECT_EQ(codeBefore(toolpath, 2, 1), "M104 T1 S220\n");
  EXPECT_EQ(codeBefore(toolpath, 3, 0), "M109 T1 S220\n");
}

/// A nozzle that heats up amid the part melts its way into it.
TEST(ToolHeating, IsWaitedForOnThePrimeTower) {
  Toolpath toolpath = inTurn();
  for (ToolpathLayer& layer : toolpath.layers) {
    layer.paths[0].role = PathRole::Travel;
    layer.paths[0].bead = Bead{};
    layer.paths[1].role = PathRole::Prime;
  }
  std::vector<Tool> tools(2);
  tools[1].temperature_c = 220.0;
  tools[1].standby_c = 150.0;
  addToolHeating(toolpath, tools, {210.0, {}, {}});
  const std::vector<PathEvent>& events = toolpath.layers[1].paths[0].events;
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(codeBefore(toolpath, 1, 0), "M109 T1 S220\n");
  EXPECT_EQ(events[0].motion, 1U) << "behind its only motion";
}

TEST(ToolHeating, IsWaitedForBesideThePartWithoutAPrimeTower) {
  Toolpath toolpath = inTurn();
  for (ToolpathLayer& layer : toolpath.layers) {
    Path way = layer.paths[0];
    way.role = PathRole::Travel;
    way.bead = Bead{};
    way.points = {layer.paths[1].points[1], layer.paths[0].points[0]};
    way.points[0].z() -= layer.height_mm;
    layer.paths.insert(layer.paths.begin(), way);
  }
  std::vector<Tool> tools(2);
  tools[1].temperature_c = 220.0;
  tools[1].standby_c = 150.0;
  addToolHeating(toolpath, tools, {210.0, {}, {}});
  validate(toolpath);
  const Path& way = toolpath.layers[1].paths[0];
  ASSERT_EQ(way.events.size(), 1U);
  EXPECT_EQ(codeBefore(toolpath, 1, 0), "M109 T1 S220\n");
  // From the end of layer 0, up by 2 mm from its top, 5 mm to the left of the part, and over the first bead.
  ASSERT_EQ(way.points.size(), 5U);
  EXPECT_NEAR((way.points[0] - Point3(100, 0, 0.2)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((way.points[1] - Point3(100, 0, 2.4)).norm(), 0.0, 1e-9) << "2 mm over what lies so far";
  EXPECT_NEAR((way.points[2] - Point3(-5, 0, 2.4)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((way.points[3] - Point3(0, 0, 2.4)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((way.points[4] - Point3(0, 0, 0.4)).norm(), 0.0, 1e-9);
  EXPECT_EQ(way.events[0].motion, 2U) << "beside the part";
  EXPECT_TRUE(way.process.is_retracted);
}

TEST(ToolHeating, KeepsAToolHotThatIsTakenAgainSoon) {
  Toolpath toolpath = inTurn();
  std::vector<Tool> tools(2);
  tools[0].standby_c = 150.0;
  tools[0].heat_s = 20.0;
  MotionLimits limits;
  limits.acceleration_mm_s2 = limits.travel_acceleration_mm_s2 = 1e9;
  addToolHeating(toolpath, tools, {210.0, limits, {}});
  EXPECT_EQ(codeBefore(toolpath, 1, 0) + codeBefore(toolpath, 2, 0), "");
  EXPECT_EQ(codeBefore(toolpath, 3, 0), "M104 T0 S150\n");  // not taken again
}

TEST(ToolHeating, LeavesToolsWithoutTemperaturesAlone) {
  Toolpath toolpath = inTurn();
  const std::string before = toolpathId(toolpath);
  addToolHeating(toolpath, std::vector<Tool>(2), {210.0, {}, {}});
  EXPECT_EQ(toolpathId(toolpath), before);
}

}  // namespace
}  // namespace lamina
