// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/plan_settings.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

class PlanSettingsSchema : public testing::Test {
 protected:
  PlanSettingsSchema() { describe(schema_, settings_); }
  PlanSettings settings_;
  SettingsSchema schema_;
};

TEST_F(PlanSettingsSchema, HoldsItsOwnDefaults) { EXPECT_NO_THROW(schema_.validate()); }

TEST_F(PlanSettingsSchema, SetsEveryFieldOnlyOnce) {
  for (const Setting& setting : schema_.settings()) {
    SCOPED_TRACE(setting.key);
    EXPECT_FALSE(setting.meaning.empty());
    for (const Setting& other : schema_.settings()) EXPECT_EQ(&other == &setting, other.key == setting.key);
  }
}

TEST_F(PlanSettingsSchema, TakesNoWallsAndAnyDensityFromNoneToSolid) {
  schema_.set("walls.count", "0");
  schema_.set("infill.density", "0");
  EXPECT_EQ(settings_.infill.density, 0.0);
  schema_.set("infill.density", "1");
  EXPECT_EQ(settings_.infill.density, 1.0);
}

TEST_F(PlanSettingsSchema, RefusesWhatCannotBePrinted) {
  for (const char* assignment :
       {"bead.width_mm=0", "bead.width_mm=nan", "bead.pitch_mm=-1", "walls.count=-1", "walls.count=1.5",
        "infill.density=1.01", "infill.strategy=spaghetti", "walls.order=sideways", "seam.placement=front",
        "travel.feed_mm_s=0", "travel.hop_mm=-0.1", "feed.infill_mm_s=0", "planning.simplification_mm=-1"}) {
    const SettingText setting = settingFromAssignment(assignment);
    EXPECT_THROW(schema_.set(setting.key, setting.text), InvalidConfig) << assignment;
  }
}

}  // namespace
}  // namespace lamina
