// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/job/profiles/layered_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/machine_choice.hpp"
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

TEST(ShippedProfiles, LayAdaptiveLayersOfTheirDefaultHeights) {
  for (const std::string& machine : shipped().names(ProfileKind::Machine)) {
    SettingsSources sources;
    sources.machine = machine;
    sources.overrides = {{"slicing.heights", "adaptive"}};
    const LayeredSettings layered = loadLayered(sources, shipped());
    if (depositsDrops(layered.settings.planning.infill.strategy)) continue;
    EXPECT_NO_THROW(validate(layered)) << machine;
  }
  SettingsSources sources;
  sources.machine = "prusa_mk4";
  sources.overrides = {{"slicing.heights", "adaptive"}, {"adaptive.greatest_mm", "0.5"}};
  EXPECT_THROW(validate(loadLayered(sources, shipped())), InvalidConfig);
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

const char* const kOwnedMachines[] = {"creality_ender_3", "prusa_mk3s",    "prusa_mk4",
                                      "voron_2_4_250",    "voron_2_4_300", "voron_2_4_350"};

/// What start code in relative E pushes over the bed after its last wait for the nozzle.
struct Purge {
  double pushed_mm = 0.0;
  double thickest_mm2 = 0.0;
  Box3 way;
};

Purge purgeOf(const std::string& code) {
  Purge purge;
  Point3 at(0, 0, 100);
  bool is_hot = false;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) {
    is_hot = is_hot || line.rfind("M109 S", 0) == 0;
    if (line.rfind("G0 ", 0) != 0 && line.rfind("G1 ", 0) != 0) continue;
    const Point3 from = at;
    double pushed_mm = 0.0;
    std::istringstream words(line.substr(3));
    for (std::string word; words >> word;) {
      const double value = std::strtod(word.c_str() + 1, nullptr);
      if (word[0] >= 'X' && word[0] <= 'Z') at[word[0] - 'X'] = value;
      if (word[0] == 'E') pushed_mm = value;
    }
    if (!is_hot || pushed_mm == 0.0) continue;
    purge.pushed_mm += pushed_mm;
    purge.thickest_mm2 = std::max(purge.thickest_mm2, pushed_mm * 2.405 / (at - from).norm());
    purge.way.include(from);
    purge.way.include(at);
  }
  return purge;
}

/// A nozzle that has oozed while it was heated lays nothing for its first centimetres. Prusa's own line
/// ends with 12.5 mm of filament of 1.75 mm over 40 mm, 0.752 mm2; Klipper, of the machines that run it,
/// takes 0.64 mm2 of a nozzle of 0.4 mm.
TEST(ShippedProfiles, TheNozzleIsPrimedAtTheEdgeOfTheBed) {
  for (const std::string machine : kOwnedMachines) {
    const JobSettings settings = loadShipped(machine, "pla", "").settings;
    const Purge purge = purgeOf(settings.program.start_code);
    EXPECT_GE(purge.pushed_mm, 10.0) << machine;
    EXPECT_LE(purge.thickest_mm2, machine.rfind("prusa_", 0) == 0 ? 0.752 : 0.64) << machine;
    EXPECT_LE(purge.way.high.z(), 0.4) << machine;
    const Box3 reach = boundingBox(buildSpaceOf(settings.machine));
    EXPECT_TRUE((purge.way.low.array() >= reach.low.array()).all() &&
                (purge.way.high.array() <= reach.high.array()).all())
        << machine;
    const Point3 to_edge = purge.way.high - reach.low;
    EXPECT_LE(std::min(to_edge.x(), to_edge.y()), 3.0) << machine;
  }
}

/// Hot, it would drip on the part below.
TEST(ShippedProfiles, TheNozzleLeavesThePartRetracted) {
  for (const std::string machine : kOwnedMachines) {
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
