// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/modifiers/slicer_settings.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

using Lines = std::vector<std::string>;

Lines settingLines(const TranslatedSettings& translation) {
  Lines lines;
  for (const SettingText& setting : translation.settings) lines.push_back(setting.key + "=" + setting.text);
  return lines;
}

JobSettings partWith(const std::vector<SettingText>& set) { return loadJobSettings("", set); }

struct Stated {
  SettingText of_slicer;
  Lines here;
};

class SettingOfASlicer : public testing::TestWithParam<Stated> {};

TEST_P(SettingOfASlicer, HasItsNameHere) {
  // Feeds that shares refer to: 50, 80, 40 mm/s; beads of 0.5 mm; two tools.
  const JobSettings part = partWith({{"feed.inner_wall_mm_s", "50"},
                                     {"feed.infill_mm_s", "80"},
                                     {"feed.skin_mm_s", "40"},
                                     {"bead.width_mm", "0.5"},
                                     {"tools.list", "[{name: a}, {name: b}]"}});
  const TranslatedSettings found = translated({GetParam().of_slicer}, part);
  EXPECT_EQ(settingLines(found), GetParam().here);
  EXPECT_TRUE(found.left_out.empty()) << found.left_out.front();
}

INSTANTIATE_TEST_SUITE_P(
    Prusa, SettingOfASlicer,
    testing::Values(Stated{{"perimeters", "4"}, {"walls.count=4"}},
                    Stated{{"fill_density", "60%"}, {"infill.density=0.6"}},
                    Stated{{"fill_density", "100%"}, {"infill.density=1", "infill.strategy=zigzag"}},
                    Stated{{"fill_pattern", "gyroid"}, {"infill.strategy=gyroid"}},
                    Stated{{"fill_pattern", "alignedrectilinear"},
                           {"infill.strategy=zigzag", "infill.alternation_deg=0"}},
                    Stated{{"fill_angle", "30"}, {"infill.angle_deg=30"}},
                    Stated{{"infill_overlap", "25%"}, {"infill.wall_overlap=0.25"}},
                    Stated{{"infill_overlap", "0.1"}, {"infill.wall_overlap=0.2"}},
                    Stated{{"top_solid_layers", "6"}, {"skins.top_layers=6"}},
                    Stated{{"bottom_solid_layers", "2"}, {"skins.bottom_layers=2"}},
                    Stated{{"top_solid_min_thickness", "0.7"}, {"skins.top_mm=0.7"}},
                    Stated{{"bottom_solid_min_thickness", "0.5"}, {"skins.bottom_mm=0.5"}},
                    Stated{{"solid_infill_below_area", "70"}, {"skins.least_infill_mm2=70"}},
                    Stated{{"perimeter_speed", "45"}, {"feed.inner_wall_mm_s=45"}},
                    Stated{{"external_perimeter_speed", "50%"}, {"feed.outer_wall_mm_s=25"}},
                    Stated{{"infill_speed", "0"}, {}},
                    Stated{{"solid_infill_speed", "75%"}, {"feed.skin_mm_s=60"}},
                    Stated{{"top_solid_infill_speed", "50%"}, {"feed.top_skin_mm_s=20"}},
                    Stated{{"bridge_speed", "15"}, {"feed.bridge_mm_s=15"}},
                    Stated{{"bridge_flow_ratio", "0.9"}, {"bridges.flow=0.9"}},
                    Stated{{"bridge_angle", "0"}, {"bridges.angle_deg=-1"}},
                    Stated{{"bridge_angle", "90"}, {"bridges.angle_deg=90"}},
                    Stated{{"extruder", "2"}, {"tool.walls=1", "tool.infill=1", "tool.skin=1"}},
                    Stated{{"extruder", "0"}, {}}, Stated{{"infill_extruder", "2"}, {"tool.infill=1"}}));

INSTANTIATE_TEST_SUITE_P(Orca, SettingOfASlicer,
                         testing::Values(Stated{{"wall_loops", "3"}, {"walls.count=3"}},
                                         Stated{{"sparse_infill_density", "35%"}, {"infill.density=0.35"}},
                                         Stated{{"sparse_infill_pattern", "zig-zag"},
                                                {"infill.strategy=zigzag"}},
                                         Stated{{"infill_direction", "10"}, {"infill.angle_deg=10"}},
                                         Stated{{"top_shell_layers", "5"}, {"skins.top_layers=5"}},
                                         Stated{{"bottom_shell_thickness", "0"}, {"skins.bottom_mm=0"}},
                                         Stated{{"outer_wall_speed", "25"}, {"feed.outer_wall_mm_s=25"}},
                                         Stated{{"internal_solid_infill_speed", "60"}, {"feed.skin_mm_s=60"}},
                                         Stated{{"print_flow_ratio", "0.95"}, {"bead.flow=0.95"}},
                                         Stated{{"wall_filament", "2"}, {"tool.walls=1"}}));

INSTANTIATE_TEST_SUITE_P(
    Cura, SettingOfASlicer,
    testing::Values(Stated{{"cura:wall_line_count", "3"}, {"walls.count=3"}},
                    Stated{{"cura:infill_sparse_density", "35"}, {"infill.density=0.35"}},
                    Stated{{"cura:infill_pattern", "lines"}, {"infill.strategy=zigzag"}},
                    Stated{{"cura:infill_overlap", "10"}, {"infill.wall_overlap=0.1"}},
                    Stated{{"cura:top_layers", "5"}, {"skins.top_layers=5"}},
                    Stated{{"cura:bottom_thickness", "0.6"}, {"skins.bottom_mm=0.6"}},
                    Stated{{"cura:speed_wall_0", "25"}, {"feed.outer_wall_mm_s=25"}},
                    Stated{{"cura:material_flow", "95"}, {"bead.flow=0.95"}},
                    Stated{{"cura:extruder_nr", "1"}, {"tool.walls=1", "tool.infill=1", "tool.skin=1"}},
                    Stated{{"cura:extruder_nr", "-1"}, {}}));

TEST(SettingsOfASlicer, TheLayerHeightOfThePartIsNoOther) {
  EXPECT_TRUE(translated({{"layer_height", "0.2"}}, JobSettings()).left_out.empty());
  EXPECT_EQ(translated({{"layer_height", "0.15"}}, JobSettings()).left_out.size(), 1U);
}

TEST(SettingsOfASlicer, ReferToFeedsOfTheirOwnRegion) {
  const TranslatedSettings found =
      translated({{"external_perimeter_speed", "50%"}, {"perimeter_speed", "30"}}, JobSettings());
  EXPECT_EQ(settingLines(found), (Lines{"feed.inner_wall_mm_s=30", "feed.outer_wall_mm_s=15"}));
}

TEST(SettingsOfASlicer, AreNamedWhereTheyHaveNoMeaningHere) {
  const TranslatedSettings found = translated({{"name", "Generic-Box"},
                                               {"volume_type", "ParameterModifier"},
                                               {"source_offset_x", "10"},
                                               {"perimeters", "many"},
                                               {"fill_density", "150%"},
                                               {"fill_pattern", "stars"},
                                               {"perimeter_speed", "50%"},
                                               {"extruder", "2"},
                                               {"support_material", "1"}},
                                              JobSettings());
  EXPECT_TRUE(found.settings.empty());
  EXPECT_EQ(found.left_out,
            (Lines{"'extruder' '2'", "'fill_density' '150%'", "'fill_pattern' 'stars'",
                   "'perimeter_speed' '50%'", "'perimeters' 'many'", "'support_material' '1'"}));
}

TEST(SettingsOfASlicer, AreShownWithoutWhatCannotBePrinted) {
  const TranslatedSettings found = translated({{"odd\x1b[2J", "1"}}, JobSettings());
  ASSERT_EQ(found.left_out.size(), 1U);
  EXPECT_EQ(found.left_out.front().find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace lamina
