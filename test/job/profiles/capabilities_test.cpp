// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/capabilities.hpp"

#include <gtest/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// What settings are refused with; empty if they are not.
std::string refusalOf(const std::vector<SettingText>& set) {
  const JobSettings settings = loadJobSettings("", set);
  try {
    validate(settings);
    return "";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

struct Bounded {
  const char* key;      ///< of the machine
  const char* enough;   ///< for what is typed: 210 and 60 degrees C, layers of 0.2 mm, fan
  const char* lacking;  ///< for them
  const char* asked;    ///< what is refused then
};

class Capabilities : public testing::TestWithParam<Bounded> {};

TEST_P(Capabilities, BoundWhatIsAsked) {
  std::vector<SettingText> set = {{"fan.use", "true"},
                                  {"program.bed_temperature_c", "60"},
                                  {"slicing.layer_height_mm", "0.2"},
                                  {GetParam().key, GetParam().enough}};
  EXPECT_EQ(refusalOf(set), "");
  set.back().text = GetParam().lacking;
  const std::string refusal = refusalOf(set);
  EXPECT_EQ(refusal.rfind(GetParam().asked, 0), 0U) << refusal;
  EXPECT_NE(refusal.find(GetParam().key), std::string::npos) << refusal;
}

INSTANTIATE_TEST_SUITE_P(
    Each, Capabilities,
    testing::Values(Bounded{"machine.greatest_nozzle_c", "210", "209.5",
                            "program.nozzle_temperature_c is 210"},
                    Bounded{"machine.greatest_bed_c", "60", "59", "program.bed_temperature_c is 60"},
                    Bounded{"machine.has_bed_heater", "true", "false", "program.bed_temperature_c is 60"},
                    Bounded{"machine.has_fan", "true", "false", "fan.use is true"},
                    Bounded{"machine.least_layer_mm", "0.2", "0.25", "slicing.layer_height_mm is 0.2"},
                    Bounded{"machine.greatest_layer_mm", "0.2", "0.15", "slicing.layer_height_mm is 0.2"},
                    Bounded{"machine.nozzle_mm", "0.25", "0.24", "slicing.layer_height_mm is 0.2"}));

TEST(InfillOfSeveralLayers, IsNoHigherThanTheNozzleLays) {
  const SettingText of_three = {"infill.every_layers", "3"};
  const SettingText high = {"slicing.layer_height_mm", "0.2"};
  EXPECT_EQ(refusalOf({of_three, high, {"machine.nozzle_mm", "0.75"}}), "") << "0.6 mm, and 0.8 of 0.75";
  EXPECT_EQ(
      refusalOf({of_three, high, {"machine.nozzle_mm", "0.74"}}),
      "infill.every_layers is 3 of 0.2 mm, which makes beads 0.6 mm high; must be at most 0.592 mm, 0.8 "
      "of machine.nozzle_mm");
  EXPECT_NE(refusalOf({of_three}).find("bead.width_mm"), std::string::npos) << "where no nozzle is known";
  EXPECT_NE(refusalOf({of_three, high, {"machine.nozzle_mm", "2"}, {"slicing.heights", "adaptive"}}), "");
}

TEST(Layers, AreNoHigherThanTheNozzlesOfSupports) {
  const std::vector<SettingText> tools = {{"slicing.layer_height_mm", "0.3"},
                                          {"tools.list.0.nozzle_mm", "0.4"},
                                          {"tools.list.1.nozzle_mm", "0.25"}};
  const auto refusalWith = [&](std::vector<SettingText> more) {
    more.insert(more.begin(), tools.begin(), tools.end());
    return refusalOf(more);
  };
  const std::string refused =
      "slicing.layer_height_mm is 0.3 mm; must be at most 0.2 mm, 0.8 of nozzle_mm of tool 1 in tools.list";
  const SettingText use = {"supports.use", "true"};
  EXPECT_EQ(refusalWith({use}), "");
  for (const char* key : {"supports.tool", "supports.interface_tool", "tool.support", "tool.interface"}) {
    EXPECT_EQ(refusalWith({use, {key, "1"}}), refused) << key;
    EXPECT_EQ(refusalWith({{key, "1"}}), "") << key << " lays nothing";
  }
  EXPECT_EQ(refusalWith({use, {"supports.tool", "1"}, {"tool.support", "0"}}), "") << "tool.support holds";
}

TEST(Layers, AreNoHigherThanTheNozzlesOfBrimsAndRafts) {
  const auto refusalWith = [&](std::vector<SettingText> more) {
    more.insert(
        more.begin(),
        {{"tools.list.0.nozzle_mm", "0.4"}, {"tools.list.1.nozzle_mm", "0.25"}, {"tool.support", "1"}});
    return refusalOf(more);
  };
  const SettingText high = {"slicing.layer_height_mm", "0.3"};
  const SettingText low = {"slicing.layer_height_mm", "0.2"};
  const std::string refused =
      "slicing.layer_height_mm is 0.3 mm; must be at most 0.2 mm, 0.8 of nozzle_mm of tool 1 in tools.list";
  EXPECT_EQ(refusalWith({high}), "") << "tool 1 lays nothing";
  EXPECT_EQ(refusalWith({high, {"brim.width_mm", "5"}}), refused);
  EXPECT_EQ(refusalWith({high, {"raft.layers", "3"}, {"raft.base_height_mm", "0.2"}}), refused);
  EXPECT_EQ(refusalWith({low, {"brim.width_mm", "5"}}), "");
  EXPECT_EQ(
      refusalWith({low, {"raft.layers", "3"}, {"raft.base_height_mm", "0.3"}}),
      "raft.base_height_mm is 0.3 mm and nozzle_mm of tool 1 in tools.list 0.25 mm; a layer is no higher "
      "than the nozzles that lay it are wide");
  EXPECT_EQ(refusalWith({low, {"raft.layers", "3"}, {"raft.base_height_mm", "0.25"}}), "");
}

TEST(Layers, OfOneToolKeepToItsNozzleInTheFirstAsWell) {
  const std::vector<SettingText> set = {{"tools.list.0.nozzle_mm", "0.4"},
                                        {"slicing.layer_height_mm", "0.32"},
                                        {"slicing.first_layer_height_mm", "0.4"}};
  EXPECT_EQ(refusalOf(set), "") << "0.8 of the nozzle, and all of it on the bed";
  std::vector<SettingText> higher = set;
  higher.back().text = "0.41";
  EXPECT_EQ(refusalOf(higher),
            "slicing.first_layer_height_mm is 0.41 mm and nozzle_mm of tool 0 in tools.list 0.4 mm; a layer "
            "is no higher than the nozzles that lay it are wide");
}

/// What a table of equal heights is refused for, equal layers are refused for.
TEST(Layers, EqualOnesKeepToTheRuleOfATable) {
  const SettingText nozzle = {"machine.nozzle_mm", "0.4"};
  const SettingText first = {"slicing.first_layer_height_mm", "0.4"};
  EXPECT_EQ(refusalOf({nozzle, first, {"slicing.layer_height_mm", "0.32"}}), "");
  EXPECT_EQ(refusalOf({nozzle, first, {"slicing.layer_height_mm", "0.33"}}),
            "slicing.layer_height_mm is 0.33 mm; must be at most 0.32 mm, 0.8 of machine.nozzle_mm");
}

TEST(AdaptiveLayers, KeepToWhatMachineAndNozzlesLay) {
  const SettingText adaptive = {"slicing.heights", "adaptive"};
  const SettingText nozzle = {"machine.nozzle_mm", "0.4"};
  const SettingText high = {"adaptive.greatest_mm", "0.5"};
  EXPECT_EQ(refusalOf({adaptive, high}), "") << "where nothing is known";
  EXPECT_EQ(refusalOf({nozzle, high}), "") << "equal layers have no use for it";
  EXPECT_EQ(refusalOf({adaptive, nozzle}), "");
  EXPECT_EQ(refusalOf({adaptive, nozzle, {"adaptive.greatest_mm", "0.32"}}), "") << "0.8 of the nozzle";
  EXPECT_EQ(refusalOf({adaptive, nozzle, high}),
            "adaptive.greatest_mm is 0.5 mm; must be at most 0.32 mm, 0.8 of machine.nozzle_mm");
  EXPECT_EQ(refusalOf({adaptive, high, {"machine.greatest_layer_mm", "0.3"}}),
            "adaptive.greatest_mm is 0.5 mm; must be at most machine.greatest_layer_mm, 0.3 mm");
  EXPECT_EQ(refusalOf({adaptive, {"machine.least_layer_mm", "0.1"}, {"adaptive.least_mm", "0.05"}}),
            "adaptive.least_mm is 0.05 mm; must be at least machine.least_layer_mm, 0.1 mm");
  EXPECT_EQ(
      refusalOf({adaptive,
                 high,
                 {"tools.list.0.nozzle_mm", "0.8"},
                 {"tools.list.1.nozzle_mm", "0.6"},
                 {"tool.infill", "1"}}),
      "adaptive.greatest_mm is 0.5 mm; must be at most 0.48 mm, 0.8 of nozzle_mm of tool 1 in tools.list");
}

TEST(LayersOfATable, KeepToWhatMachineAndNozzlesLay) {
  const test::ScratchFolder folder;
  const std::string table = folder.file("heights.csv");
  writeStl(folder.file("box.stl"), makePart("box", {{"z_mm", "1"}}));
  const auto refusalBy = [&](const std::string& rows, std::vector<SettingText> machine) {
    writeFile(table, "z_mm,height_mm\n" + rows);
    machine.push_back({"slicing.heights", "file"});
    machine.push_back({"slicing.heights_file", table});
    NoProgress nobody;
    try {
      runSliceJob({folder.file("box.stl"), "", loadJobSettings("", machine)}, nobody);
      return std::string();
    } catch (const InvalidConfig& error) {
      return std::string(error.what());
    }
  };
  const SettingText nozzle = {"machine.nozzle_mm", "0.4"};
  const std::string thirds = "0.4,0.4\n0.7,0.3\n1.0,0.3\n";
  EXPECT_EQ(refusalBy(thirds, {nozzle}), "") << "the first layer is as high as the nozzle is wide";
  EXPECT_EQ(refusalBy("0.4,0.4\n1.0,0.6\n", {nozzle}),
            "layer 1 of slicing.heights_file is 0.6 mm; must be at most 0.32 mm, 0.8 of machine.nozzle_mm");
  EXPECT_EQ(
      refusalBy("0.5,0.5\n0.75,0.25\n1.0,0.25\n", {nozzle}),
      "layer 0 of slicing.heights_file is 0.5 mm; must be at most machine.nozzle_mm, 0.4 mm: a layer is "
      "no higher than the nozzle is wide");
  EXPECT_EQ(refusalBy(thirds, {{"machine.greatest_layer_mm", "0.3"}}),
            "layer 0 of slicing.heights_file is 0.4 mm; must be at most machine.greatest_layer_mm, 0.3 mm");
  EXPECT_EQ(refusalBy("0.3,0.3\n0.6,0.3\n0.9,0.3\n1.2,0.3\n", {{"machine.greatest_layer_mm", "0.3"}}), "");
  EXPECT_EQ(refusalBy(thirds, {{"machine.least_layer_mm", "0.35"}}),
            "layer 1 of slicing.heights_file is 0.3 mm; must be at least machine.least_layer_mm, 0.35 mm");
}

TEST(UnknownCapabilities, RefuseNothing) {
  EXPECT_EQ(refusalOf({{"program.nozzle_temperature_c", "500"}}), "");
}

TEST(FirstLayer, IsNoHigherThanTheNozzleIsWide) {
  const std::vector<SettingText> set = {{"slicing.layer_height_mm", "0.2"},
                                        {"slicing.first_layer_height_mm", "0.35"}};
  const auto refusalBy = [&](const char* nozzle_mm) {
    std::vector<SettingText> all = set;
    all.push_back({"machine.nozzle_mm", nozzle_mm});
    return refusalOf(all);
  };
  EXPECT_EQ(refusalBy("0.35"), "");
  EXPECT_EQ(refusalBy("0.3"),
            "slicing.first_layer_height_mm is 0.35 mm; must be at most machine.nozzle_mm, 0.3 mm: a layer is "
            "no higher than the nozzle is wide");
}

}  // namespace
}  // namespace lamina
