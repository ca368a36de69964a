// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/part_record.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/base/sha256.hpp"

namespace lamina {
namespace {

/// A part of two layers that was held once.
struct MadePart {
  ScratchFolder folder;
  CellJournal journal{folder.path() + "/cell.db"};
  ArtefactStore store{folder.path() + "/artefacts"};
  std::int64_t job = 0;
  std::int64_t execution = 0;
  Artefact program;
  Artefact map;

  MadePart() {
    std::ofstream(folder.path() + "/a.gcode") << "G1 X1";
    program = store.keep(folder.path() + "/a.gcode", "program", "a.gcode");
    job = journal.addJob({"bracket", "bracket.stl", "gantry", {program}, "anna", 2}, 1.0);
    journal.release(job, "anna", 2.0);
    execution = journal.begin(job, "plc: bert", 3.0);
    ExecutionLog log(journal);
    LayerRow first;
    first.layer = 0;
    first.began_s = 4.0;
    first.mean_mm = -0.02;
    first.correction = "ab12";
    log.setLayer(execution, first);
    LayerRow second;
    second.layer = 1;
    second.began_s = 5.5;
    log.setLayer(execution, second);
    journal.interrupt(execution, "vacuum lost", 6.0);
    journal.goOn(execution, 7.0);
    journal.end(execution, JobState::Ended, "", 8.0);
    map = store.keepText("the map of layer 1", "correction", "layer_1.csv");
    keepRecord(journal, store, execution, {"good", 8.0, {map}});
  }
};

void replaceFile(const std::string& path, const std::string& bytes) {
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  std::ofstream(path) << bytes;
}

TEST(PartRecord, ReportsLayersAsATable) {
  MadePart made;
  EXPECT_EQ(partRecord(made.journal, made.execution, {"good", 8.0, {}}).layers_csv,
            "layer,began,ended,expected_mm,mean_mm,rms_mm,flatness_mm,worst_mm,coverage,gain,nozzle_c,bed_c,"
            "correction\n0,4.000,,,-0.02,,,,,,,,ab12\n1,5.500,,,,,,,,,,,\n");
  EXPECT_THROW(partRecord(made.journal, 99, {"good", 8.0, {}}), InvalidInput);
}

TEST(PartRecord, GivesTheMaterialWhereAnExecutorReportsItOnly) {
  MadePart made;
  const auto record = [&made] { return partRecord(made.journal, made.execution, {"good", 8.0, {}}).json; };
  EXPECT_NE(record().find("\"material_mm3\": null"), std::string::npos) << record();
  made.journal.setProgress(made.execution, {12, 10, 1, 0.0, 12.5}, 7.5);
  EXPECT_NE(record().find("\"material_mm3\": 12.5"), std::string::npos) << record();
}

TEST(PartRecord, IsReadWithAllItsDigests) {
  MadePart made;
  const CheckedRecord checked = readRecord(made.journal, made.store, made.job);
  EXPECT_TRUE(checked.faults.empty()) << checked.faults.front();
  for (const std::string& part :
       {std::string("\"serial\": \"1-1\""), made.program.sha256, std::string("\"operator\": \"plc: bert\""),
        std::string("\"vacuum lost\""), std::string("\"measured\": 1"), sha256Of(checked.record.layers_csv)})
    EXPECT_NE(checked.record.json.find(part), std::string::npos) << part;
  EXPECT_EQ(ExecutionLog(made.journal).part(made.execution)->verdict, "good");
  EXPECT_THROW(readRecord(made.journal, made.store, made.job + 1), InvalidInput);
}

TEST(PartRecord, KeepsTheMapsThatThePartWasCorrectedBy) {
  MadePart made;
  const CheckedRecord checked = readRecord(made.journal, made.store, made.job);
  ASSERT_EQ(checked.files.size(), 2U);
  EXPECT_EQ(checked.files[1].sha256, made.map.sha256);
  EXPECT_EQ(checked.files[1].name, "layer_1.csv");
  EXPECT_EQ(checked.files[1].bytes, 18U);
  std::filesystem::remove(made.store.pathOf(made.map));
  const CheckedRecord without = readRecord(made.journal, made.store, made.job);
  EXPECT_EQ(without.faults, std::vector<std::string>{"layer_1.csv is gone, or no longer has its digest"});
  EXPECT_EQ(without.files.size(), 1U);
}

TEST(PartRecord, TakesNoPathForADigest) {
  MadePart made;
  std::ofstream(made.folder.path() + "/secret.csv") << "secret";
  std::string json = readRecord(made.journal, made.store, made.job).record.json;
  json.replace(json.find(made.map.sha256), made.map.sha256.size(), "../secret");
  replaceFile(made.store.pathOf(ExecutionLog(made.journal).part(made.execution)->record), json);
  const CheckedRecord checked = readRecord(made.journal, made.store, made.job);
  ASSERT_EQ(checked.files.size(), 1U);
  EXPECT_EQ(checked.files[0].name, "a.gcode");
  ASSERT_EQ(checked.faults.size(), 2U) << "the record's own digest, and that of the map";
  EXPECT_EQ(checked.faults[1], "layer_1.csv has the digest '../secret'; expected 64 hexadecimal digits");
}

TEST(PartRecord, OfOtherTypesThanExpectedIsRead) {
  MadePart made;
  const std::string path = made.store.pathOf(ExecutionLog(made.journal).part(made.execution)->record);
  replaceFile(path, R"({"corrections": [{"sha256": 1, "bytes": "x", "kind": [], "name": {}}, 3]})");
  const CheckedRecord checked = readRecord(made.journal, made.store, made.job);
  EXPECT_EQ(checked.files.size(), 1U);
  EXPECT_GE(checked.faults.size(), 3U);
}

TEST(PartRecord, NamesEachFileThatHasChanged) {
  MadePart made;
  replaceFile(made.store.pathOf(made.program), "G1 X2");
  ASSERT_EQ(readRecord(made.journal, made.store, made.job).faults.size(), 1U);
  EXPECT_EQ(readRecord(made.journal, made.store, made.job).faults[0],
            "a.gcode is gone, or no longer has its digest");
  const PartRecord record = readRecord(made.journal, made.store, made.job).record;
  replaceFile(made.store.pathOf({sha256Of(record.layers_csv), 0, "layers", "layers.csv"}), "layer\n");
  EXPECT_EQ(readRecord(made.journal, made.store, made.job).faults.size(), 2U);
  replaceFile(made.store.pathOf(ExecutionLog(made.journal).part(made.execution)->record), "{}");
  EXPECT_EQ(readRecord(made.journal, made.store, made.job).faults.size(), 4U)
      << "record, layers, program, and the job that the record is of";
}

}  // namespace
}  // namespace lamina
