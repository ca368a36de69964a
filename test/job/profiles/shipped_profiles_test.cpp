// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/job/profiles/layered_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

ProfileLibrary shipped() { return ProfileLibrary({std::string(LAMINA_SOURCE_DIR) + "/profiles"}); }

LayeredSettings loadShipped(const std::string& machine, const std::string& material,
                            const std::string& process) {
  SettingsSources sources;
  sources.machine = machine;
  sources.material = material;
  sources.process = process;
  return loadLayered(sources, shipped());
}

class ShippedMachineProfile : public testing::TestWithParam<std::string> {};

TEST_P(ShippedMachineProfile, SlicesWithPlaAndNothingElse) {
  const test::ScratchFolder folder;
  NoProgress nobody;
  const LayeredSettings layered = loadShipped(GetParam(), "pla", "");
  validate(layered);
  const SlicedPart sliced = runSliceJob({"box", folder.file("box.gcode"), layered.settings}, nobody);
  EXPECT_GT(sliced.summary.deposited_mm3, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Each, ShippedMachineProfile,
                         testing::ValuesIn(shipped().names(ProfileKind::Machine)),
                         [](const auto& each) { return each.param; });

TEST(ShippedProfiles, EveryMaterialAndProcessCanBeLoaded) {
  for (const std::string& material : shipped().names(ProfileKind::Material)) {
    const LayeredSettings layered = loadShipped("voron_2_4_350", material, "");
    EXPECT_GT(layered.settings.material.density_g_cm3, 0.5) << material;
    EXPECT_FALSE(layered.settings.material.name.empty()) << material;
  }
  for (const std::string process : {"standard", "fine", "draft"})
    validate(loadShipped("prusa_mk3s", "petg", process));
  validate(loadShipped("bigrep_class", "pla", "large"));
}

TEST(ShippedProfiles, TheNozzleOfAnEnder3CannotMeltPaCf) {
  EXPECT_THROW(validate(loadShipped("creality_ender_3", "pa_cf", "")), InvalidConfig);
  EXPECT_THROW(validate(loadShipped("duet_large", "pla", "fine")), InvalidConfig);
  EXPECT_THROW(loadShipped("prusa_mk4", "pla", "large"), InvalidConfig);
}

}  // namespace
}  // namespace lamina
