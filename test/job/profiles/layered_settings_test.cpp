// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/layered_settings.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "job/profiles/profile_suggestion.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// A library of its own, written file by file.
class LayeredSettingsTest : public testing::Test {
 protected:
  LayeredSettingsTest() : library_({folder_.file("profiles")}) {
    for (const char* kind : {"machines", "materials", "processes"})
      std::filesystem::create_directories(folder_.file("profiles/" + std::string(kind)));
    write("machines/small",
          "profile: {kind: machine, name: small}\nmachine:\n  greatest_nozzle_c: 240\nbead.width_mm: 0.5\n");
    write("machines/grown",
          "profile: {kind: machine, name: grown, inherits: small}\nmachine: {name: belt_45}\n");
    write("materials/soft", "profile: {kind: material, name: soft}\nprogram: {nozzle_temperature_c: 200}\n");
    write("materials/hard",
          "profile:\n  kind: material\n  name: hard\n  for_machines: [grown, other]\nprogram:\n  "
          "nozzle_temperature_c: 280\n");
    write("processes/slow", "profile: {kind: process, name: slow}\nbead: {width_mm: 0.6}\n");
  }

  void write(const std::string& name, const std::string& yaml) {
    writeFile(folder_.file("profiles/" + name + ".yaml"), yaml);
  }
  std::string path(const std::string& name) const { return folder_.file("profiles/" + name + ".yaml"); }
  LayeredSettings load(const SettingsSources& sources) const { return loadLayered(sources, library_); }

  std::string refusalOf(const SettingsSources& sources) const {
    try {
      validate(load(sources));
      return "";
    } catch (const InvalidConfig& error) {
      return error.what();
    }
  }

  test::ScratchFolder folder_;
  ProfileLibrary library_;
};

SettingsSources sourcesOf(const std::string& machine, const std::string& material = "",
                          const std::string& process = "") {
  SettingsSources sources;
  sources.machine = machine;
  sources.material = material;
  sources.process = process;
  return sources;
}

TEST_F(LayeredSettingsTest, CountInTheirOrder) {
  const auto widthWith = [&](const SettingsSources& sources) {
    return load(sources).settings.planning.bead.width_mm;
  };
  SettingsSources sources;
  EXPECT_EQ(widthWith(sources), 0.4);
  sources = sourcesOf("small");
  EXPECT_EQ(widthWith(sources), 0.5);
  sources.process = "slow";
  EXPECT_EQ(widthWith(sources), 0.6);
  sources.config = folder_.file("own.yaml");
  writeFile(sources.config, "\nbead:\n  width_mm: 0.7\n");
  EXPECT_EQ(widthWith(sources), 0.7);
  sources.overrides = {{"bead.width_mm", "0.8"}};
  EXPECT_EQ(widthWith(sources), 0.8);

  std::vector<std::string> said;
  for (const SettingOrigin& origin : load(sources).explain("bead.width_mm"))
    said.push_back(origin.layer + " " + origin.text + " " + origin.place);
  EXPECT_EQ(said, (std::vector<std::string>{"built-in 0.4 ", "--machine 0.5 " + path("machines/small") + ":4",
                                            "--process 0.6 " + path("processes/slow") + ":2",
                                            "--config 0.7 " + sources.config + ":3", "--set 0.8 "}));
  EXPECT_THROW(load(sources).explain("bead.weight"), InvalidConfig);
}

TEST_F(LayeredSettingsTest, AreOfOneMachine) {
  SettingsSources sources = sourcesOf("mine.urdf");
  sources.overrides = {{"machine.name", "belt_45"}};
  try {
    load(sources);
    ADD_FAILURE() << "the description would count without a word";
  } catch (const InvalidConfig& refusal) {
    EXPECT_STREQ(
        refusal.what(),
        "machine.name is belt_45 by --set, but machine.urdf, which counts, is mine.urdf by --machine; "
        "expected one machine, as by --machine belt_45");
  }
  sources.overrides.push_back({"machine.urdf", ""});
  EXPECT_EQ(load(sources).settings.machine.name, "belt_45");
}

TEST_F(LayeredSettingsTest, TakeWhatTheyInheritFirst) {
  const LayeredSettings layered = load(sourcesOf("grown", "soft"));
  EXPECT_EQ(layered.settings.machine.name, "belt_45");
  EXPECT_EQ(layered.settings.planning.bead.width_mm, 0.5);
  EXPECT_EQ(layered.settings.program.nozzle_temperature_c, 200.0);
}

TEST_F(LayeredSettingsTest, TakeMachinesByTheirNamesAndFiles) {
  EXPECT_EQ(load(sourcesOf("gantry_45")).settings.machine.name, "gantry_45");
  EXPECT_EQ(load(sourcesOf("mine.urdf")).settings.machine.urdf, "mine.urdf");
  const std::string cell = folder_.file("cell.yaml");
  writeFile(cell, "cell: {arm: {urdf: arm.urdf}}\n");
  EXPECT_EQ(load(sourcesOf(cell)).settings.machine.urdf, cell);
  EXPECT_EQ(load(sourcesOf(path("machines/small"))).settings.planning.bead.width_mm, 0.5);
  EXPECT_NE(refusalOf(sourcesOf("tiny")).find("grown, small"), std::string::npos);
}

TEST_F(LayeredSettingsTest, FindFilesOfAProfileBesideIt) {
  write("machines/own", "profile: {kind: machine, name: own}\nmachine: {urdf: own.urdf}\n");
  EXPECT_EQ(load(sourcesOf("own")).settings.machine.urdf, folder_.file("profiles/machines/own.urdf"));
}

TEST_F(LayeredSettingsTest, RefuseAMaterialThatTheNozzleCannotMeltByFileAndLine) {
  const std::string refusal = refusalOf(sourcesOf("grown", "hard"));
  EXPECT_NE(refusal.find("cannot melt"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find(path("materials/hard") + ":6"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find(path("machines/small") + ":3"), std::string::npos) << refusal;
  EXPECT_EQ(refusalOf(sourcesOf("grown", "soft")), "");
}

TEST_F(LayeredSettingsTest, RefuseWhatIsMeantForOtherMachines) {
  EXPECT_NE(refusalOf(sourcesOf("small", "hard")).find("'hard' is for grown, other, not for 'small'"),
            std::string::npos);
}

TEST_F(LayeredSettingsTest, LeaveABedWithoutHeaterCold) {
  write("machines/cold",
        "profile: {kind: machine, name: cold}\nmachine: {has_bed_heater: false}\nprogram: "
        "{bed_temperature_c: 0}\n");
  write("materials/warm", "profile: {kind: material, name: warm}\nprogram: {bed_temperature_c: 90}\n");
  EXPECT_EQ(load(sourcesOf("cold", "warm")).settings.program.bed_temperature_c, 0.0);
  EXPECT_EQ(load(sourcesOf("small", "warm")).settings.program.bed_temperature_c, 90.0);
}

TEST_F(LayeredSettingsTest, RefuseBrokenProfilesByFileAndLine) {
  struct Broken {
    const char* yaml;
    const char* line;
  };
  for (const Broken& broken :
       {Broken{"profile: {kind: machine, name: broken}\nwalls:\n  cuont: 3\n", ":3: unknown setting"},
        Broken{"profile: {kind: machine, name: broken}\nwalls: {count: many}\n", ":2: walls.count"},
        Broken{"walls: {count: 2}\n", ":1: no profile"},
        Broken{"profile:\n  kind: printer\n  name: broken\n", ":2: profile.kind"},
        Broken{"profile:\n  kind: machine\n  name: broken\n  colour: red\n",
               ":4: unknown key 'profile.colour'"},
        Broken{"profile: {kind: machine, name: other}\n", ": profile.name is 'other'"},
        Broken{"profile: {kind: material, name: broken}\n", ": a profile of kind 'material'"},
        Broken{"profile:\n  kind: machine\n  name: broken\n  inherits: broken\n",
               ":4: inherits from 'broken'"},
        Broken{"profile:\n  kind: machine\n  name: broken\n  inherits: nothing\n",
               ":4: there is no machine"}}) {
    write("machines/broken", broken.yaml);
    const std::string refusal = refusalOf(sourcesOf("broken"));
    EXPECT_EQ(refusal.rfind(path("machines/broken") + broken.line, 0), 0U) << refusal;
  }
}

TEST(ProfileSuggestion, IsTheProfileThatSomebodyMayHaveMeant) {
  const std::vector<std::string> names = {"creality_cr_30", "creality_ender_3", "pla",
                                          "petg",           "voron_2_4_250",    "voron_2_4_300"};
  const auto likely = [&](const char* given) { return profileSuggestion(names, given); };
  EXPECT_EQ(likely("CR-30"), "; did you mean 'creality_cr_30'?");
  EXPECT_EQ(likely("Creality Ender 3"), "; did you mean 'creality_ender_3'?");
  EXPECT_EQ(likely("PLA"), "; did you mean 'pla'?");
  EXPECT_EQ(likely("Voron 2.4"), "; did you mean 'voron_2_4_250'?");
  EXPECT_EQ(likely("petgg"), "; did you mean 'petg'?");
  // One letter differs; with the five separators it would be too many.
  EXPECT_EQ(profileSuggestion({"a_b_c_d_1_2", "abxyz9"}, "ABCD-13"), "; did you mean 'a_b_c_d_1_2'?");
  EXPECT_EQ(likely("Creality Ender 4"), "; did you mean 'creality_ender_3'?");
  EXPECT_EQ(likely("a"), "") << "in most names";
  EXPECT_EQ(likely("cheese"), "");
  EXPECT_EQ(likely("-"), "");
}

TEST_F(LayeredSettingsTest, SuggestTheProfileThatIsLikeAWrongName) {
  write("machines/big_one", "profile: {kind: machine, name: big_one}\n");
  EXPECT_NE(refusalOf(sourcesOf("Big One")).find("; did you mean 'big_one'?"), std::string::npos);
}

TEST_F(LayeredSettingsTest, RefuseProfilesThatInheritInACircle) {
  write("machines/first", "profile: {kind: machine, name: first, inherits: second}\n");
  write("machines/second", "profile:\n  kind: machine\n  name: second\n  inherits: first\n");
  const std::string refusal = refusalOf(sourcesOf("first"));
  EXPECT_EQ(refusal.rfind(path("machines/second") + ":4: inherits from 'first'", 0), 0U) << refusal;
}

TEST_F(LayeredSettingsTest, AppliesProfilesOverSettingsThatAreThere) {
  JobSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  schema.set("bead.width_mm", "0.9");
  schema.set("slicing.layer_height_mm", "0.31");
  applyProfiles(schema, sourcesOf("cartesian_gantry", "soft", "slow"), library_);
  EXPECT_EQ(schema.find("program.nozzle_temperature_c")->get(), "200");
  EXPECT_EQ(schema.find("bead.width_mm")->get(), "0.6");
  EXPECT_EQ(schema.find("slicing.layer_height_mm")->get(), "0.31");
  EXPECT_THROW(applyProfiles(schema, sourcesOf("small", "hard"), library_), InvalidConfig);
  EXPECT_THROW(applyProfiles(schema, sourcesOf("small", "none"), library_), InvalidConfig);
}

}  // namespace
}  // namespace lamina
