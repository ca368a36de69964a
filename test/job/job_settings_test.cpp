// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/job_settings.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

std::map<std::string, std::string> textsOf(JobSettings settings) {
  SettingsSchema schema;
  describe(schema, settings);
  std::map<std::string, std::string> texts;
  for (const Setting& setting : schema.settings()) texts[setting.key] = setting.get();
  return texts;
}

TEST(JobSettings, CloseAndBridgePartsUnlessSetOtherwise) {
  const PlanSettings planning = loadJobSettings("", {}).planning;
  EXPECT_EQ(planning.skins.top_layers, 4);
  EXPECT_EQ(planning.skins.bottom_layers, 4);
  EXPECT_TRUE(planning.bridges.is_used);
  EXPECT_TRUE(planning.overhangs.is_used);
  EXPECT_FALSE(hasSkins(PlanSettings{}.skins)) << "the planner lays what is set";
}

TEST(JobSettings, HasTheKeysThatUsersKnow) {
  const auto texts = textsOf({});
  for (const char* key :
       {"slicing.layer_height_mm", "walls.count", "bead.width_mm", "infill.strategy", "infill.density",
        "infill.angle_deg", "machine.name", "input.unit", "part.placement"})
    EXPECT_EQ(texts.count(key), 1U) << key;
}

TEST(JobSettings, TheShippedFileHoldsEveryKeyAndTheDefaults) {
  const std::string path = std::string(LAMINA_SOURCE_DIR) + "/config/slicing.yaml";
  JobSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  EXPECT_EQ(readFile(path), settingsToYaml(schema)) << "renew it by lamina slice --print-config";
  EXPECT_EQ(textsOf(loadJobSettings(path, {})), textsOf({}));
}

TEST(JobSettings, RefusesToFillVoidsBetweenDropsWhereBeadsAreDeposited) {
  JobSettings settings;
  settings.drop_voids.is_on = true;
  EXPECT_THROW(validate(settings), InvalidConfig);
  settings.planning.infill.strategy = "drops_dense";
  EXPECT_NO_THROW(validate(settings));
  settings.planning.infill.density = 0.5;
  EXPECT_THROW(validate(settings), InvalidConfig);
}

TEST(JobSettings, RefusesRunsOfDropsAndTwoWeaves) {
  const auto refusal = [](const JobSettings& settings) -> std::string {
    try {
      validate(settings);
    } catch (const InvalidConfig& error) {
      return error.what();
    }
    return "";
  };
  JobSettings drops;
  drops.planning.infill.strategy = "drops_dense";
  drops.runs.weave.kind = WeaveKind::Sine;
  EXPECT_NE(refusal(drops).find("weave.kind is not 'none' with infill.strategy 'drops_dense'"),
            std::string::npos);
  drops.runs.weave.kind = WeaveKind::None;
  drops.runs.levels.values = "laser_power_w=100";
  EXPECT_NE(refusal(drops).find("levels.values is set with infill.strategy"), std::string::npos);
  drops.runs.levels.values.clear();
  EXPECT_EQ(refusal(drops), "");
  JobSettings woven;
  woven.runs.weave.kind = WeaveKind::Zigzag;
  EXPECT_EQ(refusal(woven), "");
  woven.program.robot.arc.weave_schedule = 3;
  EXPECT_NE(refusal(woven).find("robot_program.weave_schedule 3; expected one of them"), std::string::npos);
  woven.program.robot.arc.weave_schedule = 0;
  woven.program.rapid.weave_data = "weave1";
  EXPECT_NE(refusal(woven).find("rapid.weave_data 'weave1'; expected one of them"), std::string::npos);
}

TEST(JobSettings, RefuseWipesAlongEndsThatMove) {
  const std::vector<std::pair<std::string, std::string>> moving = {{"starts.rule", "golden"},
                                                                   {"lead.in", "line"},
                                                                   {"lead.out", "arc"},
                                                                   {"lead.overlap_mm", "5"},
                                                                   {"entry.distance_mm", "5"}};
  for (const auto& [key, value] : moving) {
    EXPECT_NO_THROW(validate(loadJobSettings("", {{key, value}})));
    try {
      validate(loadJobSettings("", {{key, value}, {"travel.wipe_mm", "2"}}));
      ADD_FAILURE() << key;
    } catch (const InvalidConfig& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find(key + " is not "), 0U) << what;
      EXPECT_NE(what.find("with travel.wipe_mm 2 mm"), std::string::npos) << what;
    }
  }
}

TEST(JobSettings, OverridesWinOverTheFile) {
  const test::ScratchFolder folder;
  std::ofstream(folder.file("a.yaml")) << "slicing: {layer_height_mm: 0.3}\nwalls:\n  count: 5\n";
  const JobSettings settings = loadJobSettings(folder.file("a.yaml"), {{"walls.count", "1"}});
  EXPECT_DOUBLE_EQ(settings.slicing.layer_height_mm, 0.3);
  EXPECT_EQ(settings.planning.walls.count, 1);
}

TEST(JobSettings, RefusesWhatIsUnknownOrOutOfBounds) {
  EXPECT_THROW(loadJobSettings("", {{"slicing.layer_hight_mm", "0.2"}}), InvalidConfig);
  for (const char* bad : {"0", "-1", "nan", "inf", "thick", "", "0.2mm"})
    EXPECT_THROW(loadJobSettings("", {{"slicing.layer_height_mm", bad}}), InvalidConfig) << bad;
}

TEST(JobSettings, RefusesAFileThatIsMissingOrNoYaml) {
  const test::ScratchFolder folder;
  std::ofstream(folder.file("a.yaml")) << "slicing: [";
  EXPECT_THROW(loadJobSettings(folder.file("a.yaml"), {}), InvalidConfig);
  EXPECT_THROW(loadJobSettings(folder.file("b.yaml"), {}), FileError);
}

TEST(JobSettings, ValidateFindsWhatCodeHasSet) {
  JobSettings settings;
  validate(settings);
  settings.slicing.layer_height_mm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(validate(settings), InvalidConfig);
}

TEST(JobSettings, TakesKeysThatOthersKnowThemBy) {
  const JobSettings settings =
      loadJobSettings("", {{"supports.on", "bed"}, {"first_layer.height_mm", "0.3"}});
  EXPECT_EQ(settings.planning.supports.foot, SupportFoot::Bed);
  EXPECT_EQ(settings.slicing.first_layer_height_mm, 0.3);
}

}  // namespace
}  // namespace lamina
