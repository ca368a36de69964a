// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/hooks/hooks.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

Path hookedPath(PathRole role, std::vector<Point3> points) {
  Path path;
  path.role = role;
  path.points = std::move(points);
  path.feed_mm_s = 10.0;
  if (role != PathRole::Travel) path.bead = Bead{0.4, 0.2};
  return path;
}

/// Layers of 0.2 mm: a travel, a wall of 10 mm, a travel, an infill of 10 mm; back at the start.
Toolpath hookedPart(std::size_t layers) {
  Toolpath toolpath;
  toolpath.part_name = "plate";
  for (std::size_t i = 0; i < layers; ++i) {
    const double z = 0.2 * static_cast<double>(i + 1);
    toolpath.layers.push_back(
        {z,
         0.2,
         {hookedPath(PathRole::Travel, {{0, 0, i > 0 ? z - 0.2 : z}, {0, 0, z}, {5, 0, z}}),
          hookedPath(PathRole::OuterWall, {{5, 0, z}, {15, 0, z}}),
          hookedPath(PathRole::Travel, {{15, 0, z}, {15, 2, z}}),
          hookedPath(PathRole::Infill, {{15, 2, z}, {5, 2, z}, {0, 0, z}})}});
  }
  return toolpath;
}

/// "layer/path/motion text" of each code.
std::vector<std::string> codesOf(const Toolpath& toolpath) {
  std::vector<std::string> codes;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p)
      for (const PathEvent& placed : toolpath.layers[l].paths[p].events)
        if (const auto* code = std::get_if<MachineCode>(&placed.event))
          codes.push_back(std::to_string(l) + "/" + std::to_string(p) + "/" + std::to_string(placed.motion) +
                          " " + code->text);
  for (const ToolpathEvent& event : toolpath.events_at_end)
    if (const auto* code = std::get_if<MachineCode>(&event)) codes.push_back("end " + code->text);
  return codes;
}

using Codes = std::vector<std::string>;

TEST(Hooks, OfLayersStandBeforeTheFirstBeadAndBehindTheLast) {
  Toolpath toolpath = hookedPart(2);
  HookSettings hooks;
  hooks.layer_start = "M117 {layer} of {layers} at {z_mm} by {height_mm}";
  hooks.layer_end = "M400";
  addHooks(toolpath, hooks, {});
  EXPECT_EQ(codesOf(toolpath), (Codes{"0/1/0 M117 0 of 2 at 0.2 by 0.2\n", "0/3/2 M400\n",
                                      "1/1/0 M117 1 of 2 at 0.4 by 0.2\n", "1/3/2 M400\n"}));
}

TEST(Hooks, OfThePartStandAtItsEnds) {
  Toolpath toolpath = hookedPart(1);
  HookSettings hooks;
  hooks.part_start = "; {part} from {x_mm} {y_mm}";
  hooks.part_end = "; {share}";
  HookSite site;
  site.bed_from_part.translation() = Point3(100.0, 50.5, 0.0);
  addHooks(toolpath, hooks, site);
  EXPECT_EQ(codesOf(toolpath), (Codes{"0/0/0 ; plate from 100 50.5\n", "end ; 1\n"}));
}

TEST(Hooks, OfRolesStandWhereTheRoleChanges) {
  Toolpath toolpath = hookedPart(2);
  HookSettings hooks;
  hooks.before_role = {{"infill", "M204 S{layer}"}};
  hooks.after_role = {{"infill", "M204 S500"}, {"outer_wall", "; {role}"}};
  addHooks(toolpath, hooks, {});
  EXPECT_EQ(codesOf(toolpath), (Codes{"0/1/1 ; outer_wall\n", "0/3/0 M204 S0\n", "0/3/2 M204 S500\n",
                                      "1/1/1 ; outer_wall\n", "1/3/0 M204 S1\n", "1/3/2 M204 S500\n"}));
}

TEST(Hooks, AtALayerAndAtAHeightStandOnce) {
  Toolpath toolpath = hookedPart(20);
  HookSettings hooks;
  hooks.at_layer = {{"12", "M117 nuts"}};
  hooks.at_height_mm = {{"2.0", "M117 reached"}, {"3.05", "M117 beyond"}};
  addHooks(toolpath, hooks, {});
  // Layer 10 begins at 2.0 mm, layer 16 at 3.2 mm: the first that begins at or above.
  EXPECT_EQ(codesOf(toolpath),
            (Codes{"10/1/0 M117 reached\n", "12/1/0 M117 nuts\n", "16/1/0 M117 beyond\n"}));
}

TEST(Hooks, CountHeightsFromTheBed) {
  Toolpath toolpath = hookedPart(20);
  HookSettings hooks;
  hooks.at_height_mm = {{"2", "M117 {z_mm}"}};
  HookSite site;
  site.bed_from_part.translation().z() = 1.0;
  addHooks(toolpath, hooks, site);
  EXPECT_EQ(codesOf(toolpath), (Codes{"5/1/0 M117 2.2\n"}));
}

TEST(Hooks, OfToolsStandBehindTheChange) {
  Toolpath toolpath = hookedPart(2);
  for (ToolpathLayer& layer : toolpath.layers) layer.paths[2].tool = layer.paths[3].tool = 1;
  HookSettings hooks;
  hooks.tool_change = "M117 {tool}\nM104 T{next_tool} S180";
  addHooks(toolpath, hooks, {});
  EXPECT_EQ(codesOf(toolpath), (Codes{"0/2/0 M117 1\nM104 T0 S180\n", "1/0/0 M117 0\nM104 T1 S180\n",
                                      "1/2/0 M117 1\n"}));  // no further change
}

TEST(Hooks, KnowTheTime) {
  Toolpath toolpath = hookedPart(1);
  HookSettings hooks;
  hooks.layer_start = "{time_s} {left_s}";
  HookSite site;
  site.limits.acceleration_mm_s2 = site.limits.travel_acceleration_mm_s2 = 1e9;
  addHooks(toolpath, hooks, site);
  // 5 mm of travel of 32.39 mm in all, at 10 mm/s.
  ASSERT_EQ(codesOf(toolpath).size(), 1U);
  EXPECT_EQ(codesOf(toolpath)[0].substr(6, 4), "0.5 ");
  EXPECT_NEAR(std::stod(codesOf(toolpath)[0].substr(10)), 1.0 + 0.2 + 1.0 + std::sqrt(29.0) / 10.0, 2e-3);
}

TEST(Hooks, LeaveOutLinesWithoutValue) {
  Toolpath toolpath = hookedPart(1);
  HookSettings hooks;
  hooks.layer_start = "M104 S{nozzle_temperature_c}\nM140 S{bed_temperature_c}";
  HookSite site;
  site.nozzle_temperature_c = 215.0;
  addHooks(toolpath, hooks, site);
  EXPECT_EQ(codesOf(toolpath), (Codes{"0/1/0 M104 S215\n"}));
}

TEST(Hooks, RefuseWhatCannotBe) {
  const auto refused = [](const HookSettings& hooks) {
    Toolpath toolpath = hookedPart(3);
    EXPECT_THROW(addHooks(toolpath, hooks, {}), InvalidConfig);
  };
  HookSettings hooks;
  hooks.layer_start = "M117 {layr}";
  refused(hooks);
  hooks.layer_start = "M117 {layer";
  refused(hooks);
  hooks.layer_start = "G1 X0";
  refused(hooks);
  hooks.layer_start = "M117 a\r\nM117 b";
  refused(hooks);
  hooks.layer_start.clear();
  for (int i = 0; i < 1000; ++i) hooks.layer_start += "M400\n";
  EXPECT_NO_THROW(requireConsistent(hooks)) << "a block of YAML ends its last line, too";
  hooks.layer_start += "M400";
  refused(hooks);
  hooks.layer_start += "\n";
  refused(hooks);
  hooks = {};
  hooks.at_layer = {{"3", "M400"}};
  refused(hooks);
  hooks.at_layer = {{"one", "M400"}};
  refused(hooks);
  hooks = {};
  hooks.at_height_mm = {{"0.6", "M400"}};
  refused(hooks);
  hooks = {};
  hooks.before_role = {{"walls", "M400"}};
  refused(hooks);
  hooks.before_role = {{"travel", "M400"}};
  refused(hooks);
}

TEST(Hooks, ThatMoveAreDeclared) {
  Toolpath toolpath = hookedPart(1);
  HookSettings hooks;
  hooks.layer_start = "G28 X";
  hooks.moves_axes = true;
  addHooks(toolpath, hooks, {});
  EXPECT_TRUE(std::get<MachineCode>(toolpath.layers[0].paths[1].events.at(0).event).moves_axes);
}

TEST(Hooks, ChangeNothingIfThereAreNone) {
  Toolpath toolpath = hookedPart(3);
  const std::string before = toolpathId(toolpath);
  addHooks(toolpath, {}, {});
  addPauses(toolpath, {}, {}, {});
  EXPECT_EQ(toolpathId(toolpath), before);
}

TEST(Pauses, AreParkedAndReturn) {
  Toolpath toolpath = hookedPart(5);
  PauseSettings pauses;
  pauses.at_layers = {2};
  pauses.at_heights_mm = {0.4, 0.8};  // where layers 2 and 4 begin
  addPauses(toolpath, pauses, {}, {});
  validate(toolpath);
  for (const std::size_t l : {std::size_t{2}, std::size_t{4}}) {
    ASSERT_EQ(toolpath.layers[l].paths.size(), 5U);
    const Path& wait = toolpath.layers[l].paths[1];
    const double z = 0.2 * static_cast<double>(l + 1);
    EXPECT_TRUE(wait.process.is_retracted);
    ASSERT_EQ(wait.points.size(), 5U);
    EXPECT_LT((wait.points[1] - Point3(5, 0, z + 2.0)).norm(), 1e-12);   // lifted by cooling.lift_mm
    EXPECT_LT((wait.points[2] - Point3(-5, 0, z + 2.0)).norm(), 1e-12);  // beside the part, from x 0 on
    EXPECT_EQ(wait.points[4], Point3(5, 0, z));
    ASSERT_EQ(wait.events.size(), 1U);
    EXPECT_EQ(wait.events[0].motion, 2U);
    EXPECT_TRUE(std::holds_alternative<OperatorPause>(wait.events[0].event));
  }
  EXPECT_EQ(toolpath.layers[3].paths.size(), 4U);
}

/// Parts one after the other: of 5 layers, of 2 and of 4.
Toolpath partByPart() {
  Toolpath toolpath = hookedPart(5);
  for (const std::size_t layers : {std::size_t{2}, std::size_t{4}}) {
    const Toolpath part = hookedPart(layers);
    toolpath.layers.insert(toolpath.layers.end(), part.layers.begin(), part.layers.end());
  }
  return toolpath;
}

/// Whoever lays a nut into one part lays one into each.
TEST(Pauses, AtAHeightComeInEachPartThatIsHighEnough) {
  Toolpath toolpath = partByPart();
  PauseSettings pauses;
  pauses.at_heights_mm = {0.4};
  addPauses(toolpath, pauses, {}, {});
  std::vector<std::size_t> paused;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    if (toolpath.layers[l].paths.size() == 5) paused.push_back(l);
  // Layers that begin at 0.4 mm: the third of the first part and of the last, of layers 7 to 10.
  EXPECT_EQ(paused, (std::vector<std::size_t>{2, 9}));
}

TEST(Hooks, AtAHeightStandInEachPartThatIsHighEnough) {
  Toolpath toolpath = partByPart();
  HookSettings hooks;
  hooks.at_height_mm = {{"0.6", "M117 up"}};
  addHooks(toolpath, hooks, {});
  EXPECT_EQ(codesOf(toolpath), (Codes{"3/1/0 M117 up\n", "10/1/0 M117 up\n"}));
}

TEST(Pauses, AreAnnounced) {
  Toolpath toolpath = hookedPart(3);
  PauseSettings pauses;
  pauses.at_layers = {1};
  addPauses(toolpath, pauses, {}, {});
  HookSettings hooks;
  hooks.pause = "M300 S440";
  hooks.layer_start = "M117 {layer}";
  addHooks(toolpath, hooks, {});
  const auto& events = toolpath.layers[1].paths[1].events;
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(std::get<MachineCode>(events[0].event).text, "M300 S440\n");
  EXPECT_TRUE(std::holds_alternative<OperatorPause>(events[1].event));
  EXPECT_EQ(codesOf(toolpath)[2], "1/2/0 M117 1\n");  // once the pause is over
}

TEST(Pauses, RefuseLayersThatThereAreNot) {
  Toolpath toolpath = hookedPart(3);
  PauseSettings pauses;
  pauses.at_layers = {3};
  EXPECT_THROW(addPauses(toolpath, pauses, {}, {}), InvalidConfig);
  pauses.at_layers = {0.5};
  EXPECT_THROW(requireConsistent(pauses), InvalidConfig);
  pauses = {};
  pauses.at_heights_mm = {0.6};
  EXPECT_THROW(addPauses(toolpath, pauses, {}, {}), InvalidConfig);
}

}  // namespace
}  // namespace lamina
