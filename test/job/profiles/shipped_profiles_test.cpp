// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdio>

#include "lamina/base/error.hpp"
#include "lamina/job/profiles/layered_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine_settings.hpp"
#include "lamina/kinematics/model/build_space.hpp"
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

/// Hot, it would drip on the part below.
TEST(ShippedProfiles, TheNozzleLeavesThePartRetracted) {
  for (const std::string machine :
       {"creality_ender_3", "prusa_mk3s", "prusa_mk4", "voron_2_4_250", "voron_2_4_300", "voron_2_4_350"}) {
    const JobSettings settings = loadShipped(machine, "pla", "").settings;
    const std::string& code = settings.program.end_code;
    const std::size_t retracted = code.find("\nM83\nG1 E-1 ");
    const std::size_t lifted = code.find("\nG0 Z5 ");
    const std::size_t aside = code.find("\nG90\nG0 X");
    ASSERT_NE(aside, std::string::npos) << machine;
    EXPECT_LT(retracted, lifted) << machine;
    EXPECT_LT(lifted, aside) << machine;
    Point2 at = Point2::Zero();
    ASSERT_EQ(std::sscanf(code.c_str() + aside, "\nG90\nG0 X%lf Y%lf", &at.x(), &at.y()), 2) << code;
    const Box3 reach = boundingBox(buildSpaceOf(settings.machine));
    EXPECT_TRUE((at.array() >= reach.low.head<2>().array()).all() &&
                (at.array() <= reach.high.head<2>().array()).all())
        << machine << ' ' << at.transpose();
  }
}

TEST(ShippedProfiles, TheNozzleOfAnEnder3CannotMeltPaCf) {
  EXPECT_THROW(validate(loadShipped("creality_ender_3", "pa_cf", "")), InvalidConfig);
  EXPECT_THROW(validate(loadShipped("duet_large", "pla", "fine")), InvalidConfig);
  EXPECT_THROW(loadShipped("prusa_mk4", "pla", "large"), InvalidConfig);
}

}  // namespace
}  // namespace lamina
