// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/giving_way.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/job/profiles/layered_settings.hpp"
#include "lamina/job/profiles/machine_defaults.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {
namespace {

ProfileLibrary profilesOfLamina() { return ProfileLibrary({std::string(LAMINA_SOURCE_DIR) + "/profiles"}); }

LayeredSettings on5Axes(const std::string& material, const std::vector<SettingText>& typed) {
  SettingsSources sources;
  sources.machine = "open5x_i3";
  sources.material = material;
  sources.overrides = typed;
  return loadLayered(sources, profilesOfLamina());
}

std::string refusedFor(const LayeredSettings& layered) {
  try {
    validate(layered);
    return "";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

bool hasNote(const std::vector<std::string>& notes, const std::string& text) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST(GivingWay, CombingOfAProfileGivesWayToEveryModeWithoutPlaneLayers) {
  for (const std::string& mode : slicingModes().names()) {
    if (mode == "inclined") continue;
    const LayeredSettings layered = on5Axes("pla", {{"slicing.mode", mode}});
    EXPECT_EQ(refusedFor(layered), "") << mode;
    EXPECT_EQ(layered.settings.planning.travel.comb == Combing::Inside, hasPlaneLayers(mode)) << mode;
    EXPECT_EQ(layered.settings.giving_way.notes.size(), hasPlaneLayers(mode) ? 0U : 1U) << mode;
  }
  const std::vector<SettingOrigin> said =
      on5Axes("pla", {{"slicing.mode", "adapted"}}).explain("travel.comb");
  EXPECT_EQ(said.back().layer, "slicing.mode");
  EXPECT_EQ(said.back().text, "none");
}

TEST(GivingWay, WhatIsTypedIsRefusedAsEver) {
  EXPECT_EQ(refusedFor(on5Axes("pla", {{"slicing.mode", "adapted"}, {"travel.comb", "inside"}}))
                .rfind("travel.comb is not 'none' with slicing.mode 'adapted'", 0),
            0U);
  EXPECT_EQ(refusedFor(on5Axes("pla", {{"slicing.mode", "adapted"}, {"travel.wipe_mm", "2"}}))
                .rfind("travel.wipe_mm is 2 with slicing.mode 'adapted'", 0),
            0U);
  EXPECT_THROW(validate(loadJobSettings("", {{"slicing.mode", "adapted"}, {"travel.comb", "inside"}})),
               InvalidConfig);
}

/// As the node slices, whose profiles stand in the settings already.
TEST(GivingWay, HoldsWithoutSourcesToo) {
  JobSettings settings;
  settings.slicing.mode = "adapted";
  settings.planning.travel.comb = Combing::Inside;
  settings.planning.travel.wipe_mm = 2.0;
  const JobSettings left = withMachineDefaults(settings, {"travel.wipe_mm"});
  EXPECT_EQ(left.planning.travel.comb, Combing::None);
  EXPECT_EQ(left.planning.travel.wipe_mm, 2.0) << "typed";
  EXPECT_EQ(left.giving_way.notes.size(), 1U);
}

TEST(GivingWay, ShrinkageEnlargesPartsOfAllModesButThoseOnABase) {
  const std::vector<SettingText> adapted = {{"slicing.mode", "adapted"}, {"compensation.shrink_xy", "0.01"}};
  EXPECT_EQ(refusedFor(on5Axes("abs", adapted)), "");
  EXPECT_EQ(on5Axes("abs", adapted).settings.compensation.shrink_xy, 0.01);
  EXPECT_EQ(on5Axes("abs", adapted).settings.compensation.shrink_z, 0.004);

  for (const std::vector<SettingText>& on_base :
       {std::vector<SettingText>{{"slicing.mode", "conformal"}},
        std::vector<SettingText>{{"slicing.mode", "auto"}, {"conformal.base", "base.stl"}}}) {
    const LayeredSettings layered = on5Axes("abs", on_base);
    EXPECT_EQ(refusedFor(layered), "");
    EXPECT_EQ(layered.settings.compensation.shrink_xy, 0.0);
    EXPECT_EQ(layered.settings.compensation.shrink_z, 0.0);
    EXPECT_TRUE(hasNote(layered.settings.giving_way.notes, "compensation.shrink_z of the profile"));
  }
  EXPECT_EQ(refusedFor(on5Axes("pla", {{"slicing.mode", "conformal"}, {"compensation.shrink_z", "0.01"}}))
                .rfind("compensation.shrink_z is 0.01 with slicing.mode 'conformal'", 0),
            0U);
}

/// 0.5 % in the layers and 1 % across them, of a box of 20 mm.
TEST(GivingWay, AShrinkingPartIsAdaptedAtItsGrownSize) {
  NoProgress nobody;
  const SlicedPart sliced = runSliceJob({"box", "",
                                         on5Axes("pla", {{"slicing.mode", "adapted"},
                                                         {"compensation.shrink_xy", "0.005"},
                                                         {"compensation.shrink_z", "0.01"}})
                                             .settings},
                                        nobody);
  EXPECT_NEAR(sliced.summary.mesh_volume_mm3, 8000.0 / (0.995 * 0.995 * 0.99), 1e-6);
  EXPECT_TRUE(hasNote(sliced.summary.notes, "travel.comb of the profile is left out, as 'none'"));
}

TEST(GivingWay, AutoTriesModesWithoutCombing) {
  NoProgress nobody;
  const SlicedPart sliced =
      runSliceJob({"tee", "", on5Axes("abs", {{"slicing.mode", "auto"}}).settings}, nobody);
  ASSERT_GT(sliced.summary.candidates.size(), 1U);
  for (const ModeCandidate& candidate : sliced.summary.candidates) {
    EXPECT_EQ(candidate.refusal.find("travel.comb"), std::string::npos) << candidate.refusal;
    EXPECT_EQ(candidate.refusal.find("compensation."), std::string::npos) << candidate.refusal;
  }
  EXPECT_EQ(sliced.summary.mode, "multi_direction");
  EXPECT_TRUE(hasNote(sliced.summary.notes, "travel.comb of the profile is left out"));
}

TEST(GivingWay, AutoCombsPlaneLayers) {
  NoProgress nobody;
  const SlicedPart sliced =
      runSliceJob({"box", "", on5Axes("abs", {{"slicing.mode", "auto"}}).settings}, nobody);
  EXPECT_EQ(sliced.summary.mode, "planar");
  EXPECT_FALSE(hasNote(sliced.summary.notes, "travel.comb"));
}

}  // namespace
}  // namespace lamina
