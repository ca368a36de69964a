// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/plan_consistency.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// What the settings, as `key=value`, are refused for; empty if they are not.
std::string refusalOf(const std::string& strategy, const std::vector<std::string>& assignments) {
  PlanSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  schema.set("infill.strategy", strategy);
  for (const std::string& assignment : assignments) {
    const SettingText setting = settingFromAssignment(assignment);
    schema.set(setting.key, setting.text);
  }
  try {
    requireConsistent(settings);
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return "";
}

class DropConsistency : public testing::TestWithParam<const char*> {};

TEST_P(DropConsistency, TakesTheDefaultsAndWhatAgreesWithThem) {
  EXPECT_EQ(refusalOf(GetParam(), {}), "");
  EXPECT_EQ(refusalOf(GetParam(), {"infill.density=1", "walls.count=0", "skirt.count=0", "drops.contours=3"}),
            "");
}

TEST_P(DropConsistency, RefusesWhatDropsDoNotFollow) {
  for (const char* assignment : {"infill.density=0.5", "infill.density=0", "infill.pitch_mm=0.5",
                                 "infill.outer_layers=2", "infill.bead_width_mm=0.6", "walls.count=3",
                                 "skirt.count=2", "voids.refill=beads", "bead.flow=0.9"}) {
    const SettingText setting = settingFromAssignment(assignment);
    const std::string refusal = refusalOf(GetParam(), {assignment});
    for (const std::string& reported : {setting.key, setting.text, std::string("expected")})
      EXPECT_NE(refusal.find(reported), std::string::npos) << assignment << ": " << refusal;
    EXPECT_EQ(refusalOf("zigzag", {assignment}), "");
  }
}

TEST_P(DropConsistency, RefusesDropsNearerThanTheirOverlapAllows) {
  // 0.8 x 0.5 mm
  const std::vector<std::string> drops = {"drops.diameter_mm=0.5", "drops.most_overlap=0.2"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = drops;
    all.insert(all.end(), more.begin(), more.end());
    return refusalOf(GetParam(), all);
  };
  EXPECT_EQ(with({"drops.pitch_mm=0.4"}), "");
  EXPECT_EQ(with({"drops.pitch_mm=0.5", "drops.line_spacing_mm=0.4"}), "");
  EXPECT_NE(with({"drops.pitch_mm=0.39"}).find("drops.pitch_mm is 0.39 mm; must be at least 0.4 mm"),
            std::string::npos);
  EXPECT_NE(with({"drops.pitch_mm=0.5", "drops.line_spacing_mm=0.39"}).find("drops.line_spacing_mm is 0.39"),
            std::string::npos);
}

TEST(VaseConsistency, RefusesWhatAVaseDoesNotFollow) {
  EXPECT_EQ(refusalOf("vase", {"vase.base_layers=3", "walls.count=2"}), "");
  EXPECT_EQ(refusalOf("vase", {"walls.count=0"}), "");
  for (const char* assignment :
       {"walls.count=7", "infill.density=0.3", "voids.refill=beads", "ironing.use=true"})
    EXPECT_NE(refusalOf("vase", {assignment}).find(settingFromAssignment(assignment).key), std::string::npos)
        << assignment;
}

TEST(HybridConsistency, RefusesWhatLinesForMetalDoNotFollow) {
  const std::string metal = "hybrid.lines=metal";
  EXPECT_EQ(refusalOf("hybrid", {metal}), "");
  EXPECT_EQ(refusalOf("hybrid", {"raster.direction=fewest_turns"}), "");
  EXPECT_NE(refusalOf("hybrid", {metal, "raster.direction=fewest_turns"}).find("raster.direction"),
            std::string::npos);
  // Their name in the release before.
  EXPECT_NE(refusalOf("hybrid", {"hybrid.lines=documented", "raster.direction=fewest_turns"}), "");
  const std::string refusal = refusalOf("hybrid", {metal, "hybrid.add_above=1", "hybrid.delete_below=5"});
  EXPECT_NE(refusal.find("hybrid.add_above is 1 spacings"), std::string::npos) << refusal;
}

TEST(PitchConsistency, IsHalfToTwiceTheWidthThatABeadFills) {
  // Of a bead of 0.4 x 0.2 mm: 0.4 - (1 - pi / 4) 0.2 = 0.35708 mm.
  EXPECT_NO_THROW(requireSensiblePitch({0.4, 0.0}, 0.2));
  EXPECT_NO_THROW(requireSensiblePitch({0.4, 0.18}, 0.2));
  EXPECT_NO_THROW(requireSensiblePitch({0.4, 0.71}, 0.2));
  for (const double pitch_mm : {0.01, 0.17, 0.72, 50.0})
    EXPECT_THROW(requireSensiblePitch({0.4, pitch_mm}, 0.2), InvalidConfig) << pitch_mm;
}

TEST(ToolConsistency, PurgesIntoHiddenInfillOnly) {
  const auto refusal = [](const std::vector<std::string>& more) {
    std::vector<std::string> all = {"tools.purge_into_infill=true", "skins.top_layers=2",
                                    "skins.bottom_layers=2"};
    all.insert(all.end(), more.begin(), more.end());
    return refusalOf("zigzag", all);
  };
  EXPECT_EQ(refusal({"tools.purge_mm3=40"}), "");
  EXPECT_NE(refusal({}).find("tools.purge_mm3 has no volume"), std::string::npos) << refusal({});
  for (const char* seen : {"infill.density is 1", "infill.pitch_mm is 0.4", "infill.outer_layers is 2",
                           "skins.top_layers is 0", "skins.bottom_layers is 0"}) {
    std::string assignment = seen;
    assignment.replace(assignment.find(" is "), 4, "=");
    const std::string reported = refusal({"tools.purge_mm3=40", assignment});
    EXPECT_NE(reported.find(seen), std::string::npos) << reported;
  }
  EXPECT_EQ(refusal({"tools.purge_mm3=40", "skins.top_layers=0", "skins.top_mm=0.4"}), "");
}

TEST(ToolConsistency, NamesTheKeyAndItsValue) {
  const std::string tools = "tools.list=[{name: a}, {name: b}]";
  EXPECT_NE(refusalOf("vase", {tools, "tool.infill=1"}).find("tool.infill is 1"), std::string::npos);
  const std::string of_supports = refusalOf("zigzag", {tools, "supports.interface_tool=4"});
  EXPECT_NE(of_supports.find("supports.interface_tool is 4"), std::string::npos) << of_supports;
  EXPECT_EQ(refusalOf("zigzag", {"supports.tool=3"}),
            "supports.tool is 3; tools.list has 0 tools, counted from 0");
  EXPECT_NE(refusalOf("zigzag", {"supports.interface_tool=1"}).find("supports.interface_tool is 1"),
            std::string::npos);
  EXPECT_EQ(refusalOf("zigzag", {"supports.tool=0"}), "");
}

TEST(IroningConsistency, ReportsWhatSkinsThereAre) {
  const std::string reported = refusalOf("zigzag", {"ironing.use=true"});
  EXPECT_NE(reported.find("skins.top_layers 0 and skins.top_mm 0 mm"), std::string::npos) << reported;
}

INSTANTIATE_TEST_SUITE_P(Strategies, DropConsistency,
                         testing::Values("drops_contour", "drops_dense", "drops_raster"));

TEST(PlanConsistency, RefusesBeadsMoreThanTwiceAsHighAsWide) {
  PlanSettings settings;
  settings.bead.width_mm = 0.4;
  EXPECT_NO_THROW(requireSensibleWidths(settings, 0.8));
  EXPECT_THROW(requireSensibleWidths(settings, 0.81), InvalidConfig);
  EXPECT_THROW(requireSensibleWidths(settings, 5.0), InvalidConfig);
}

TEST(PlanConsistency, RefusesBeadsMoreThanFiftyTimesAsWideAsHigh) {
  PlanSettings settings;
  settings.bead.width_mm = 10.0;
  EXPECT_NO_THROW(requireSensibleWidths(settings, 0.2));
  EXPECT_THROW(requireSensibleWidths(settings, 0.19), InvalidConfig);
}

}  // namespace
}  // namespace lamina
