// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/machine_defaults.hpp"

#include <gtest/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/profiles/layered_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

std::string textIn(JobSettings settings, const std::string& key) {
  SettingsSchema schema;
  describe(schema, settings);
  return schema.find(key)->get();
}

/// A machine of its own kind, written as a profile.
class MachineDefaultsTest : public testing::Test {
 protected:
  SettingsSources machine(const std::string& yaml) const {
    SettingsSources sources;
    sources.machine = folder_.file("own.yaml");
    writeFile(sources.machine, "profile: {kind: machine, name: own}\n" + yaml);
    return sources;
  }
  static LayeredSettings load(const SettingsSources& sources) {
    return loadLayered(sources, ProfileLibrary({}));
  }
  static std::string refusalOf(const SettingsSources& sources) {
    try {
      validate(load(sources));
      return "";
    } catch (const InvalidConfig& error) {
      return error.what();
    }
  }

  test::ScratchFolder folder_;
};

TEST_F(MachineDefaultsTest, AFanThatNobodyTypedGivesWay) {
  SettingsSources sources = machine("machine:\n  has_fan: false\nfan: {use: true}\n");
  EXPECT_EQ(refusalOf(sources), "") << "a profile that is inherited from has it";
  const std::vector<SettingOrigin> said = load(sources).explain("fan.use");
  EXPECT_EQ(said.back().text, "false");
  EXPECT_EQ(said.back().layer, "machine.has_fan");
  EXPECT_EQ(said.back().place, folder_.file("own.yaml") + ":3");

  sources.overrides = {{"fan.use", "true"}};
  EXPECT_EQ(refusalOf(sources).rfind("fan.use is true with machine.has_fan false", 0), 0U);
  sources.overrides.clear();
  sources.config = folder_.file("typed.yaml");
  writeFile(sources.config, "fan: {use: true}\n");
  EXPECT_NE(refusalOf(sources).find("fan.use at " + sources.config + ":1"), std::string::npos);
  EXPECT_EQ(load(machine("machine: {has_fan: true}\n")).explain("fan.use").size(), 1U);
}

TEST_F(MachineDefaultsTest, ABedThatNobodyTypedStaysCold) {
  SettingsSources sources = machine("machine: {has_bed_heater: false}\n");
  EXPECT_EQ(refusalOf(sources), "");
  EXPECT_EQ(load(sources).settings.program.bed_temperature_c, 0.0);
  sources.overrides = {{"program.bed_temperature_c", "50"}};
  EXPECT_EQ(refusalOf(sources).rfind("program.bed_temperature_c is 50", 0), 0U);
}

struct Nozzle {
  const char* nozzle_mm;
  const char* width_mm;
  const char* height_mm;
  const char* least_mm;
  const char* greatest_mm;
};

class BeadsOfANozzle : public MachineDefaultsTest, public testing::WithParamInterface<Nozzle> {};

TEST_P(BeadsOfANozzle, AreAsWideAndHalfAsHigh) {
  const LayeredSettings layered =
      load(machine("machine: {nozzle_mm: " + std::string(GetParam().nozzle_mm) + "}\n"));
  EXPECT_NO_THROW(validate(layered));
  EXPECT_EQ(textIn(layered.settings, "bead.width_mm"), GetParam().width_mm);
  EXPECT_EQ(textIn(layered.settings, "slicing.layer_height_mm"), GetParam().height_mm);
  EXPECT_EQ(textIn(layered.settings, "slicing.first_layer_height_mm"), GetParam().height_mm);
  EXPECT_EQ(textIn(layered.settings, "adaptive.least_mm"), GetParam().least_mm);
  EXPECT_EQ(textIn(layered.settings, "adaptive.greatest_mm"), GetParam().greatest_mm);
  EXPECT_EQ(textIn(layered.settings, "bead.pitch_mm"), "0") << "follows width and height by itself";
}

INSTANTIATE_TEST_SUITE_P(Each, BeadsOfANozzle,
                         testing::Values(Nozzle{"0", "0.4", "0.2", "0.1", "0.3"},
                                         Nozzle{"0.25", "0.25", "0.125", "0.0625", "0.1875"},
                                         Nozzle{"0.4", "0.4", "0.2", "0.1", "0.3"},
                                         Nozzle{"0.6", "0.6", "0.3", "0.15", "0.45"},
                                         Nozzle{"0.8", "0.8", "0.4", "0.2", "0.6"}));

TEST_F(MachineDefaultsTest, ANozzleOfFourTenthsChangesNothing) {
  const LayeredSettings layered = load(machine("machine: {nozzle_mm: 0.4}\n"));
  EXPECT_EQ(layered.origins.size(), 1U);
}

TEST_F(MachineDefaultsTest, WhatIsStatedStays) {
  const char* const kStated =
      "machine: {nozzle_mm: 0.8}\nbead: {width_mm: 0.9}\nadaptive: {greatest_mm: 0.18}\n";
  SettingsSources sources = machine(kStated);
  sources.overrides = {{"slicing.layer_height_mm", "0.5"}, {"first_layer.height_mm", "0.35"}};
  const LayeredSettings layered = load(sources);
  EXPECT_EQ(textIn(layered.settings, "bead.width_mm"), "0.9");
  EXPECT_EQ(textIn(layered.settings, "slicing.layer_height_mm"), "0.5");
  EXPECT_EQ(textIn(layered.settings, "slicing.first_layer_height_mm"), "0.35");
  EXPECT_EQ(textIn(layered.settings, "adaptive.greatest_mm"), "0.18");
  EXPECT_EQ(textIn(layered.settings, "adaptive.least_mm"), "0.18") << "no higher than the greatest";
  EXPECT_NO_THROW(validate(layered));
  sources.overrides = {{"slicing.layer_height_mm", "0.85"}};
  EXPECT_EQ(refusalOf(sources).rfind(
                "slicing.layer_height_mm is 0.85 mm; must be at most 0.64 mm, 0.8 of machine.nozzle_mm", 0),
            0U);
}

TEST_F(MachineDefaultsTest, HeightsKeepToWhatTheMachineLays) {
  const LayeredSettings low =
      load(machine("machine:\n  nozzle_mm: 0.8\n  greatest_layer_mm: 0.36\n  least_layer_mm: 0.25\n"));
  EXPECT_EQ(textIn(low.settings, "slicing.layer_height_mm"), "0.36");
  EXPECT_EQ(low.explain("slicing.layer_height_mm").back().layer, "machine.greatest_layer_mm");
  EXPECT_EQ(low.explain("slicing.layer_height_mm").back().place, folder_.file("own.yaml") + ":4");
  EXPECT_EQ(textIn(low.settings, "adaptive.least_mm"), "0.25");
  const LayeredSettings high = load(machine("machine: {least_layer_mm: 0.3}\n"));
  EXPECT_EQ(textIn(high.settings, "slicing.layer_height_mm"), "0.3");
  EXPECT_EQ(textIn(high.settings, "slicing.first_layer_height_mm"), "0.3");
  EXPECT_EQ(textIn(high.settings, "bead.width_mm"), "0.4") << "the nozzle is not known";
  EXPECT_NO_THROW(validate(high));
}

TEST_F(MachineDefaultsTest, ModesOfEqualLayersAreNotRefusedForAFirstLayerThatNobodyTyped) {
  for (const char* const mode : {"planar", "auto", "curved", "conformal", "heightfield", "adapted"}) {
    SettingsSources sources = machine("machine: {nozzle_mm: 0.6}\n");
    sources.overrides = {{"slicing.mode", mode}, {"slicing.layer_height_mm", "0.25"}};
    EXPECT_EQ(refusalOf(sources), "") << mode;
  }
}

TEST_F(MachineDefaultsTest, AutoFollowsLikeLevelLayersUnlessSettingsMayChooseEqualOnes) {
  const auto first = [](std::vector<SettingText> overrides) {
    overrides.push_back({"machine.nozzle_mm", "0.6"});
    overrides.push_back({"slicing.layer_height_mm", "0.25"});
    overrides.push_back({"slicing.mode", "auto"});
    return loadJobSettings("", overrides).slicing.first_layer_height_mm;
  };
  EXPECT_EQ(first({}), 0.3);
  EXPECT_EQ(first({{"auto.follow_skins", "true"}}), 0.25);
  EXPECT_EQ(first({{"conformal.base", "base.stl"}}), 0.25);
}

TEST_F(MachineDefaultsTest, HoldWithoutProfilesToo) {
  EXPECT_EQ(loadJobSettings("", {{"machine.nozzle_mm", "0.6"}}).planning.bead.width_mm, 0.6);
  const std::string file = folder_.file("typed.yaml");
  writeFile(file, "machine: {nozzle_mm: 0.6}\nbead: {width_mm: 0.7}\n");
  const JobSettings settings = loadJobSettings(file, {{"first_layer.height_mm", "0.2"}});
  EXPECT_EQ(settings.planning.bead.width_mm, 0.7);
  EXPECT_EQ(settings.slicing.layer_height_mm, 0.3);
  EXPECT_EQ(settings.slicing.first_layer_height_mm, 0.2) << "typed by its former name";
}

TEST_F(MachineDefaultsTest, WhatDiffersFromTheBuiltInHasBeenStated) {
  EXPECT_TRUE(changedKeys(JobSettings()).empty());
  JobSettings settings;
  settings.planning.walls.count = 7;
  settings.capabilities.nozzle_mm = 0.6;
  EXPECT_EQ(changedKeys(settings), (std::set<std::string>{"machine.nozzle_mm", "walls.count"}));
}

TEST_F(MachineDefaultsTest, PartsAreSlicedInTheLayersOfTheNozzle) {
  NoProgress nobody;
  const auto layersBy = [&](const char* nozzle) {
    return runSliceJob({"box", "", loadJobSettings("", {{"machine.nozzle_mm", nozzle}})}, nobody)
        .summary.layers;
  };
  const std::size_t usual = layersBy("0.4");
  EXPECT_GT(usual, 10U);
  EXPECT_EQ(2 * layersBy("0.8"), usual);
}

}  // namespace
}  // namespace lamina
