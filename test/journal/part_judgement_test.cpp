// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/part_judgement.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/journal/execution_log.hpp"
#include "lamina/journal/part_record.hpp"

namespace lamina {
namespace {

using Parsed = nlohmann::json;

/// Two jobs, of which each has made a part.
struct TwoParts {
  ScratchFolder folder;
  CellJournal journal{folder.path() + "/cell.db"};
  ArtefactStore store{folder.path() + "/artefacts"};
  std::int64_t execution = 0;
  Artefact map = store.keepText("a map", "correction", "layer_1.csv");

  TwoParts() {
    const Artefact program = store.keepText("G1 X1", "program", "a.gcode");
    for (int i = 0; i < 2; ++i) {
      const std::int64_t job = journal.addJob({"bracket", "", "gantry", {program}, "anna", 1}, 1.0);
      journal.release(job, "anna", 2.0);
      execution = journal.begin(job, "anna", 3.0);
      journal.end(execution, JobState::Ended, "", 8.0);
      keepRecord(journal, store, execution, {"good", 8.0, {map}});
    }
  }
  Parsed record(std::int64_t job) { return Parsed::parse(readRecord(journal, store, job).record.json); }
};

TEST(PartJudgement, DoesNotMakeAChangedRecordGood) {
  TwoParts made;
  const ExecutionLog log(made.journal);
  const std::string path = made.store.pathOf(log.part(log.ofJob(1)->id)->record);
  writeFile(path, R"({"verdict": {"value": "good"}})");
  try {
    judgePart(made.journal, made.store, {1, "scrap", "anna", "", 20.0});
    FAIL() << "a record that somebody has changed is given a digest";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(std::string(error.what()).find("the record of part 1-1 was changed since it was kept"), 0U)
        << error.what();
  }
  EXPECT_FALSE(readRecord(made.journal, made.store, 1).faults.empty());
}

TEST(PartJudgement, IsInJournalRecordAndAudit) {
  TwoParts made;
  const Parsed before = made.record(1);
  const JudgedPart judged =
      judgePart(made.journal, made.store, {1, "scrap", "page: bert", "a hole in layer 4", 20.5});
  EXPECT_EQ(judged.serial, "1-1");
  EXPECT_EQ(judged.before, "good");
  Parsed after = made.record(1);
  EXPECT_EQ(after["verdict"],
            Parsed::parse(R"({"value":"scrap","by":"page: bert","time":20.5,"reason":"a hole in layer 4",)"
                          R"("before":"good"})"));
  after["verdict"] = before["verdict"];
  EXPECT_EQ(after, before) << "the rest stays";
  EXPECT_TRUE(readRecord(made.journal, made.store, 1).faults.empty());
  EXPECT_EQ(made.record(2)["verdict"]["value"], "good") << "of another job";
  EXPECT_FALSE(made.journal.firstBadAudit());
  // Of no job named: the last one made.
  EXPECT_EQ(judgePart(made.journal, made.store, {0, "rework", "anna", "", 21.0}).serial, "2-1");
  EXPECT_EQ(judgePart(made.journal, made.store, {2, "good", "anna", "", 22.0}).before, "rework");
}

TEST(PartJudgement, RefusesWhatIsNoVerdictAndNoPart) {
  TwoParts made;
  EXPECT_THROW(judgePart(made.journal, made.store, {1, "aborted", "anna", "", 20.0}), InvalidInput);
  EXPECT_THROW(judgePart(made.journal, made.store, {1, "scrap", "", "", 20.0}), InvalidInput);
  EXPECT_THROW(judgePart(made.journal, made.store, {7, "scrap", "anna", "", 20.0}), InvalidInput);
  ScratchFolder folder;
  CellJournal empty(folder.path() + "/cell.db");
  EXPECT_THROW(judgePart(empty, made.store, {0, "scrap", "anna", "", 20.0}), InvalidInput);
}

// As of a scan that comes after the end of the program.
TEST(PartJudgement, RenewsARecordWithWhatCameLater) {
  TwoParts made;
  judgePart(made.journal, made.store, {2, "rework", "anna", "", 20.0});
  LayerRow row;
  row.layer = 0;
  row.mean_mm = 0.03;
  ExecutionLog(made.journal).setLayer(made.execution, row);
  EXPECT_EQ(made.record(2)["layers"]["measured"], 0);
  renewRecord(made.journal, made.store, made.execution, 21.0);
  const CheckedRecord checked = readRecord(made.journal, made.store, 2);
  EXPECT_TRUE(checked.faults.empty()) << checked.faults.front();
  EXPECT_NE(checked.record.layers_csv.find("\n0,,,,0.03,"), std::string::npos) << checked.record.layers_csv;
  const Parsed record = Parsed::parse(checked.record.json);
  EXPECT_EQ(record["layers"]["measured"], 1);
  EXPECT_EQ(record["verdict"]["value"], "rework");
  EXPECT_EQ(record["corrections"][0]["sha256"], made.map.sha256);
  renewRecord(made.journal, made.store, 99, 21.0);
}

}  // namespace
}  // namespace lamina
