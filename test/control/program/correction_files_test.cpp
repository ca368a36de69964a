// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/program/correction_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/control_layers.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// Half a tenth more at all of the first bead.
CorrectionMap mapOfLayer(std::size_t layer, const std::string& toolpath_id = "planned") {
  return {toolpath_id, layer, 1, {{0, 0.5, {{0.05, 0.0, 0.0}}}}};
}

void writeMap(const std::string& file, const CorrectionMap& map) { writeFile(file, correctionMapCsv(map)); }

std::string refusalOf(const std::string& path) {
  try {
    readCorrectionFiles(path);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(CorrectionFiles, AToolpathReadsBackWithItsNumbersAndItsId) {
  Toolpath part = test::stackedBeads(2);
  part.layers[0].paths[0].points[0].x() = 1.0 / 3.0;
  const ProgrammedToolpath read = readProgrammedToolpath(programmedToolpathCsv({"planned", part}), "file");
  EXPECT_EQ(read.id, "planned");
  ASSERT_EQ(read.toolpath.layers.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(read.toolpath.layers[k].paths.size(), part.layers[k].paths.size());
    for (std::size_t p = 0; p < part.layers[k].paths.size(); ++p)
      EXPECT_EQ(read.toolpath.layers[k].paths[p].points, part.layers[k].paths[p].points) << k << ", " << p;
  }
  EXPECT_THROW(readProgrammedToolpath("layer,path\n", "file"), InvalidProgram);
  EXPECT_THROW(readProgrammedToolpath("#TOOLPATH: \n", "file"), InvalidProgram);
  EXPECT_THROW(readProgrammedToolpath("#TOOLPATH: a", "file"), InvalidProgram) << "and no toolpath";
}

TEST(CorrectionFiles, AFolderGivesItsMapsByLayer) {
  const test::ScratchFolder folder;
  writeMap(folder.file("correction_10.csv"), mapOfLayer(10));
  writeMap(folder.file("correction_9.csv"), mapOfLayer(9));
  writeFile(folder.file("loop_report.csv"), "none of them\n");
  const std::vector<FiledMap> maps =
      readCorrectionFiles(std::filesystem::path(folder.file("x")).parent_path());
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[0].map.layer, 9U);
  EXPECT_EQ(maps[1].map.layer, 10U);
  EXPECT_EQ(maps[1].file, folder.file("correction_10.csv"));
  EXPECT_EQ(readCorrectionFiles(folder.file("correction_9.csv")).size(), 1U) << "a file of its own";
}

TEST(CorrectionFiles, WhatCannotBeReadWholeIsRefusedByName) {
  const test::ScratchFolder folder;
  const std::string here = std::filesystem::path(folder.file("x")).parent_path();
  EXPECT_NE(refusalOf(here).find("holds no correction maps"), std::string::npos);
  EXPECT_NE(refusalOf(folder.file("none.csv")).find("none.csv"), std::string::npos);
  writeMap(folder.file("layer_1.csv"), mapOfLayer(1));
  std::string damaged = correctionMapCsv(mapOfLayer(2));
  damaged.replace(damaged.find("0.05"), 4, "0.06");
  writeFile(folder.file("layer_2.csv"), damaged);
  EXPECT_NE(refusalOf(here).find("layer_2.csv, line 4: the digest is"), std::string::npos) << refusalOf(here);
  writeMap(folder.file("layer_2.csv"), mapOfLayer(1));
  EXPECT_NE(refusalOf(here).find("layer_2.csv: the map is of layer 1, as that of"), std::string::npos);
  writeFile(folder.file("layer_2.csv"), "secret,words\n1,2\n");
  EXPECT_EQ(refusalOf(here).find("secret"), std::string::npos) << "another file is not quoted";
}

TEST(CorrectionFiles, ARecordSaysWhichMapsCount) {
  const test::ScratchFolder folder;
  const std::string here = std::filesystem::path(folder.file("x")).parent_path();
  writeMap(folder.file("layer_1.csv"), mapOfLayer(1));
  writeMap(folder.file("layer_2.csv"), mapOfLayer(2));
  const auto record = [&](const std::string& rows) {
    writeFile(folder.file("record.csv"),
              "# program_sha256 0\n# toolpath planned\nlayer,sequence,digest\n" + rows);
  };
  record("0,0,none\n1,1," + digestOf(mapOfLayer(1)) + "\n2,0,none\n");
  ASSERT_EQ(readCorrectionFiles(here).size(), 1U) << "layer 2 was deposited as planned";
  record("1,1," + digestOf(mapOfLayer(2)) + "\n");
  EXPECT_NE(refusalOf(here).find("layer_1.csv: the map's digest is"), std::string::npos);
  record("7,1," + digestOf(mapOfLayer(7)) + "\n");
  EXPECT_NE(refusalOf(here).find("record.csv: layer 7 was deposited by map"), std::string::npos);
}

TEST(CorrectionFiles, ARecordSaysFromWhereLaterMapsOfALayerHold) {
  const test::ScratchFolder folder;
  const std::string here = std::filesystem::path(folder.file("x")).parent_path();
  CorrectionMap later = mapOfLayer(1);
  later.sequence = 4;
  const AppliedRow begun{1, 1, digestOf(mapOfLayer(1)), 20};
  const AppliedRow trimmed{1, 4, digestOf(later), 33, true};
  EXPECT_EQ(appliedMapFile(begun), "layer_1.csv");
  EXPECT_EQ(appliedMapFile(trimmed), "layer_1_4.csv");
  writeMap(folder.file(appliedMapFile(begun)), mapOfLayer(1));
  writeMap(folder.file(appliedMapFile(trimmed)), later);
  EXPECT_NE(refusalOf(here).find("expected one map per layer"), std::string::npos) << "no record yet";
  writeFile(folder.file("record.csv"),
            appliedRecordCsv({"0", "planned", "first"}, {{0, 0, "", 2}, begun, trimmed}));
  const std::vector<FiledMap> maps = readCorrectionFiles(here);
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[0].map.sequence, 1U);
  EXPECT_EQ(maps[0].from_line, 20U);
  const auto of = recordedJob(here);
  ASSERT_TRUE(of);
  EXPECT_EQ(of->program_sha256, "0");
  EXPECT_EQ(of->toolpath_id, "planned");
  EXPECT_EQ(of->job, "first");
  EXPECT_EQ(maps[1].map.sequence, 4U);
  EXPECT_EQ(maps[1].from_line, 33U);
  writeFile(folder.file("record.csv"), "layer,sequence,digest,from_line\n1,1," + begun.digest + ",soon\n");
  EXPECT_NE(refusalOf(here).find("record.csv, line 2: 'soon' stands for"), std::string::npos)
      << refusalOf(here);
}

TEST(CorrectionFiles, AMapOfAnotherProgramIsReported) {
  const ProgrammedToolpath planned{"planned", test::stackedBeads(2)};
  EXPECT_EQ(defectOf(mapOfLayer(1), planned), "");
  EXPECT_EQ(defectOf(mapOfLayer(1, "other"), planned), "is of toolpath other; expected toolpath planned");
  EXPECT_EQ(defectOf(mapOfLayer(2), planned), "is of layer 2; the toolpath has 2");
  CorrectionMap beyond = mapOfLayer(1);
  beyond.paths[0].path = 4;
  EXPECT_EQ(defectOf(beyond, planned), "of layer 1 is of path 4; the layer has 4");
  CorrectionMap high = mapOfLayer(1);
  high.paths[0].stations[0].dz_mm = 1.6;
  EXPECT_NE(defectOf(high, planned).find("moves the nozzle by 1.6"), std::string::npos);
}

}  // namespace
}  // namespace lamina
