// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/cell_controller/kept_corrections.hpp"

#include <gtest/gtest.h>
#include <sys/time.h>

#include <fstream>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/sha256.hpp"
#include "lamina/journal/part_record.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "support/control_layers.hpp"
#include "support/corrected_programs.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr double kBegan = 1.7e9;  // s, UTC

std::string keptProgram() {
  std::string text;
  writeGcode(test::stackedBeads(3), Eigen::Isometry3d::Identity(), {},
             [&](std::string_view piece) { text += piece; });
  return text;
}

CorrectionMap keptMap(std::size_t layer) {
  const Toolpath part = test::stackedBeads(3);
  const LayerCells cells = layerCells(part.layers[layer], layer, 0.5);
  return correctionMap(cells, {std::vector<double>(cells.size(), 0.2), {}, {}}, toolpathId(part), 1);
}

/// A job, and a folder as the streamer has left it, whose second layer was deposited by a map.
struct DepositedPart {
  test::ScratchFolder folder;
  test::ScratchFolder maps;
  CellJournal journal{folder.file("cell.db")};
  ArtefactStore store{folder.file("artefacts")};
  std::int64_t execution = 0;

  explicit DepositedPart(const std::string& recorded_program = keptProgram()) {
    const Artefact program = store.keepText(keptProgram(), "program", "beads.gcode");
    const std::int64_t job = journal.addJob({"beads", "beads", "gantry", {program}, "anna"}, kBegan);
    journal.release(job, "anna", kBegan);
    execution = journal.begin(job, "anna", kBegan);
    const Toolpath part = test::stackedBeads(3);
    const CorrectionMap map = keptMap(1);
    const AppliedRow row{1, 1, digestOf(map), 1};
    writeFile(maps.file("toolpath.csv"), programmedToolpathCsv({toolpathId(part), part}));
    writeFile(maps.file("layer_1.csv"), correctionMapCsv(map));
    writeFile(maps.file("layer_2.csv"),
              correctionMapCsv(keptMap(2)));  // of an earlier job: no record names it
    writeFile(maps.file("record.csv"),
              appliedRecordCsv({sha256Of(recorded_program), toolpathId(part), "the job"}, {row}));
    setWritten(kBegan + 60.0);
    journal.end(execution, JobState::Ended, "", kBegan + 100.0);
  }

  void setWritten(double utc_s) const {
    const timeval at{static_cast<time_t>(utc_s), 0};
    const timeval both[2] = {at, at};
    ASSERT_EQ(::utimes(maps.file("record.csv").c_str(), both), 0);
  }
  std::vector<Artefact> kept() {
    const ExecutionRow row = ExecutionLog(journal).execution(execution);
    return keptCorrections(store, maps.file(""), journal.job(row.job), row);
  }
};

TEST(KeptCorrections, MakeWhatWasSentAgainByteForByte) {
  DepositedPart part;
  keepRecord(part.journal, part.store, part.execution, {"good", kBegan + 101.0, part.kept()});
  const std::string sent = correctedByMaps("beads", keptProgram(), test::recordedIn(part.maps.file(""))).text;
  ASSERT_NE(sent, keptProgram());
  const test::ScratchFolder again;
  const CheckedRecord record = readRecord(part.journal, part.store, 1);
  EXPECT_TRUE(record.faults.empty());
  ASSERT_EQ(record.files.size(), 4U);
  for (const Artefact& file : record.files)
    writeFile(again.file(file.name), readFile(part.store.pathOf(file)));
  EXPECT_EQ(
      correctedByMaps("beads", readFile(again.file("beads.gcode")), test::recordedIn(again.file(""))).text,
      sent);
}

TEST(KeptCorrections, AreThoseOfTheExecutionAlone) {
  DepositedPart part;
  EXPECT_EQ(part.kept().size(), 3U);
  part.setWritten(kBegan - 10.0);
  EXPECT_TRUE(part.kept().empty()) << "the record of a job before it";
  part.setWritten(kBegan + 110.0);
  EXPECT_TRUE(part.kept().empty()) << "the record of a job after it";
  DepositedPart other("G1 X1\n");
  EXPECT_TRUE(other.kept().empty()) << "of another program";
}

TEST(KeptCorrections, OfNoFolderAreNone) {
  DepositedPart part;
  const ExecutionRow row = ExecutionLog(part.journal).execution(part.execution);
  EXPECT_TRUE(keptCorrections(part.store, "", part.journal.job(row.job), row).empty());
  EXPECT_TRUE(
      keptCorrections(part.store, part.folder.file("nowhere"), part.journal.job(row.job), row).empty());
}

}  // namespace
}  // namespace lamina
