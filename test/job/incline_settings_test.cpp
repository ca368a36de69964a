// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/incline_settings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

InclineJob jobOf(const std::vector<SettingText>& settings) {
  return inclineJob(loadInclineSettings("", settings), "a.gcode", "b.gcode");
}

TEST(InclineSettings, RotateBy45DegreesAboutXInTheRoomOfTheLargeGantryByDefault) {
  const InclineJob job = jobOf({});
  const Point3 turned = job.map->map(Point3(1, 2, 3));
  EXPECT_LT((turned - Point3(1, -M_SQRT1_2, 5 * M_SQRT1_2)).norm(), 1e-12);
  EXPECT_EQ(job.axes, nullptr);
  ASSERT_TRUE(job.settings.limits_mm);
  EXPECT_EQ(job.settings.limits_mm->high, Point3(1300, 2500, 1000));
  EXPECT_FALSE(job.settings.tool_axis);
  EXPECT_FALSE(job.settings.decimals);
  EXPECT_FALSE(job.settings.layer_height_mm);
  EXPECT_FALSE(job.settings.initial_extrusion);
  EXPECT_FALSE(jobOf({{"incline.mode", "listing"}}).settings.limits_mm) << "which checks nothing";
}

TEST(InclineSettings, TakeEveryMap) {
  const auto mapped = [](const std::vector<SettingText>& settings) {
    return jobOf(settings).map->map(Point3(1, 2, 3));
  };
  EXPECT_LT((mapped({{"incline.axis", "0,0,7"}, {"incline.angle_deg", "90"}}) - Point3(-2, 1, 3)).norm(),
            1e-12);
  EXPECT_EQ(mapped({{"incline.map", "scale"}, {"incline.factors", "2,1,0.5"}}), Point3(2, 2, 1.5));
  EXPECT_EQ(mapped({{"incline.map", "shear"}, {"incline.shear", "y,z,0.5"}}), Point3(1, 3.5, 3));
  EXPECT_EQ(mapped({{"incline.map", "matrix"}, {"incline.matrix", "0,1,0,9,1,0,0,8,0,0,1,7"}}),
            Point3(11, 9, 10));
}

TEST(InclineSettings, RefuseWhatIsForAnotherMap) {
  for (const std::vector<SettingText>& settings : std::vector<std::vector<SettingText>>{
           {{"incline.map", "scale"}},
           {{"incline.factors", "1,1,1"}},
           {{"incline.map", "scale"}, {"incline.factors", "1,1,1"}, {"incline.angle_deg", "30"}},
           {{"incline.map", "shear"}, {"incline.shear", "y"}},
           {{"incline.map", "shear"}, {"incline.shear", "y,z,"}},
           {{"incline.axis", "w"}},
           {{"incline.axis", "1,0"}},
           {{"incline.belt_deg", "10"}},
           {{"incline.belt_deg", "45"}, {"machine.name", "belt_45"}},
           {{"incline.limits_mm", "0,0,0,1,1,1"}, {"machine.name", "gantry_45"}}})
    EXPECT_THROW(jobOf(settings), InvalidConfig) << settings[0].key << " " << settings.back().text;
}

TEST(InclineSettings, TakeLimitsHeadAndAxesOfTheMachine) {
  const InclineJob gantry = jobOf({{"machine.name", "large_gantry_45_reverse"}});
  ASSERT_TRUE(gantry.settings.tool_axis);
  EXPECT_LT((*gantry.settings.tool_axis - Point3(0, -M_SQRT1_2, -M_SQRT1_2)).norm(), 1e-9);
  EXPECT_EQ(gantry.axes, nullptr);
  const InclineJob belt = jobOf({{"machine.name", "belt_45"}});
  ASSERT_TRUE(belt.axes);
  // y_machine = z / sin a, belt = -y + z cot a.
  EXPECT_LT((belt.axes->map(Point3(5, 2, 3)) - Point3(5, 3 * M_SQRT2, 1)).norm(), 1e-9);
  const test::ScratchFolder folder;
  writeFile(folder.file("m.urdf"), machineByName("belt_45").urdf);
  const InclineJob described = jobOf({{"machine.urdf", folder.file("m.urdf")}});
  EXPECT_EQ(described.axes->map(Point3(5, 2, 3)), belt.axes->map(Point3(5, 2, 3)));
}

TEST(InclineSettings, ListsAreReadWholeOrNotAtAll) {
  for (const char* text : {"1", "1,2,3", "1,", ",1", "1,x", "1;2", "1, 2", "nan,1"})
    EXPECT_THROW(jobOf({{"incline.table_position_mm", text}}), InvalidConfig) << text;
  EXPECT_EQ(*jobOf({{"incline.table_position_mm", "1.5,-2"}}).settings.table_position_mm, Point2(1.5, -2));
  EXPECT_FALSE(jobOf({{"incline.table_position_mm", "1,2"}, {"incline.table_position_mm", ""}})
                   .settings.table_position_mm);
}

TEST(InclineSettings, SurviveTheWayThroughAFile) {
  const test::ScratchFolder folder;
  InclineSettings settings = loadInclineSettings(
      "", {{"incline.begin_code", "M117 \"a\"\nG4 P1"}, {"incline.final_position_mm", "1,2,900.125"}});
  SettingsSchema schema;
  describe(schema, settings);
  writeFile(folder.file("a.yaml"), settingsToYaml(schema));
  const InclineSettings read = loadInclineSettings(folder.file("a.yaml"), {{"incline.decimals", "4"}});
  EXPECT_EQ(read.transform.begin_code, "M117 \"a\"\nG4 P1");
  EXPECT_EQ(read.final_position_mm, (std::vector<double>{1.0, 2.0, 900.125}));
  EXPECT_EQ(read.decimals, 4);
}

}  // namespace
}  // namespace lamina
