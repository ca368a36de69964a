// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rviz_panel/incline/incline_form.hpp"

#include <gtest/gtest.h>

#include <map>

#include "lamina/base/error.hpp"
#include "lamina/job/incline_settings.hpp"

namespace {

using lamina::InclineForm;

InclineForm filled() {
  InclineForm form;
  form.source = "/parts/blade.gcode";
  form.output = "/parts/other.gcode";
  form.angle_deg = 30.0;
  form.axis = "0,-1,0.5";
  form.machine = "large_gantry_45";
  form.begin_code = "M104 S200\nM140 S90";
  form.end_code = "M84 ; off";
  form.table_position_mm = {650.0, 1250.5};
  form.final_position_mm = {0.0, -1.0, 900.0};
  form.drops_build_aids = true;
  return form;
}

TEST(InclineForm, AsksForWhatItHoldsInTheKeysOfTheNode) {
  const lamina::InclineRequest request = lamina::requestOf(filled());
  EXPECT_EQ(request.program, "/parts/blade.gcode");
  EXPECT_EQ(request.output, "/parts/other.gcode");
  const lamina::InclineSettings settings = lamina::loadInclineSettings("", request.settings);
  EXPECT_DOUBLE_EQ(settings.angle_deg, 30.0);
  EXPECT_EQ(settings.axis, "0,-1,0.5");
  EXPECT_EQ(settings.machine.name, "large_gantry_45");
  EXPECT_EQ(settings.transform.begin_code, "M104 S200\nM140 S90");
  EXPECT_EQ(settings.transform.end_code, "M84 ; off");
  EXPECT_EQ(settings.table_position_mm, (std::vector<double>{650.0, 1250.5}));
  EXPECT_EQ(settings.final_position_mm, (std::vector<double>{0.0, -1.0, 900.0}));
  EXPECT_EQ(settings.transform.build_aids, lamina::BuildAids::Dropped);
}

TEST(InclineForm, AsksFor45DegAboutXBesideTheSourceIfOnlyThatIsGiven) {
  InclineForm form;
  form.source = "Cubo.gcode";
  const lamina::InclineRequest request = lamina::requestOf(form);
  EXPECT_EQ(request.output, "Cubo_rotate.gcode");
  const lamina::InclineSettings settings = lamina::loadInclineSettings("", request.settings);
  EXPECT_DOUBLE_EQ(settings.angle_deg, 45.0);
  EXPECT_EQ(settings.axis, "x");
  EXPECT_TRUE(settings.table_position_mm.empty());
  EXPECT_TRUE(settings.final_position_mm.empty());
  EXPECT_EQ(settings.transform.build_aids, lamina::BuildAids::Kept);
  for (const auto& setting : request.settings)
    EXPECT_NE(setting.key, "machine.name") << "the node's own machine would be overridden";
}

TEST(InclineForm, RefusesWhatCannotBeRun) {
  const auto changed = [](auto change) {
    InclineForm form = filled();
    change(form);
    return form;
  };
  EXPECT_THROW(lamina::requestOf(InclineForm()), lamina::InvalidInput);
  EXPECT_THROW(lamina::requestOf(changed([](InclineForm& form) { form.source = "part.stl"; })),
               lamina::InvalidInput);
  EXPECT_THROW(lamina::requestOf(changed([](InclineForm& form) { form.output = "part.txt"; })),
               lamina::InvalidInput);
  EXPECT_THROW(lamina::requestOf(changed([](InclineForm& form) { form.output = form.source; })),
               lamina::InvalidInput);
  EXPECT_THROW(lamina::requestOf(changed([](InclineForm& form) { form.angle_deg = 91.0; })),
               lamina::InvalidConfig);
  for (const char* axis : {"w", "0,0,0", "1,2", ""})
    EXPECT_THROW(lamina::requestOf(changed([axis](InclineForm& form) { form.axis = axis; })),
                 lamina::InvalidConfig)
        << axis;
}

TEST(InclineForm, ComesBackFromWhatIsSaved) {
  const InclineForm form = lamina::formFrom(lamina::textsOf(filled()));
  EXPECT_EQ(form.source, filled().source);
  EXPECT_EQ(form.output, filled().output);
  EXPECT_EQ(form.angle_deg, filled().angle_deg);
  EXPECT_EQ(form.axis, filled().axis);
  EXPECT_EQ(form.machine, filled().machine);
  EXPECT_EQ(form.begin_code, filled().begin_code);
  EXPECT_EQ(form.end_code, filled().end_code);
  EXPECT_EQ(form.table_position_mm, filled().table_position_mm);
  EXPECT_EQ(form.final_position_mm, filled().final_position_mm);
  EXPECT_EQ(form.drops_build_aids, filled().drops_build_aids);
}

TEST(InclineForm, RefusesWhatWasSavedWrongly) {
  EXPECT_THROW(lamina::formFrom({{"angle", "45"}}), lamina::InvalidConfig);
  EXPECT_THROW(lamina::formFrom({{"angle_deg", "steep"}}), lamina::InvalidConfig);
  EXPECT_THROW(lamina::formFrom({{"axis", "0,0,0"}}), lamina::InvalidConfig);
  EXPECT_THROW(lamina::formFrom({{"table_position_mm", "1,2,3"}}), lamina::InvalidConfig);
}

TEST(InclineForm, NamesTheOutputOfAProgramOnly) {
  EXPECT_EQ(lamina::outputFor("a/b.gcode"), "a/b_rotate.gcode");
  EXPECT_EQ(lamina::outputFor("a/b.stl"), "");
  EXPECT_EQ(lamina::outputFor(""), "");
}

}  // namespace
