// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/part_record.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lamina/base/sha256.hpp"
#include "web/site_of_fakes.hpp"

namespace lamina::test {
namespace {

/// A cell that has made a part of "G28" by job 1.
PartRecord makePart(const std::string& folder) {
  CellJournal journal(folder + "/cell.db");
  ArtefactStore store(folder + "/artefacts");
  const std::int64_t job = journal.addJob(
      {"part.gcode", "bracket", "cell", {store.keepText("G28\n", "program", "part.gcode")}, "anna"}, 1.0);
  journal.release(job, "anna", 2.0);
  const std::int64_t execution = journal.begin(job, "anna", 3.0);
  LayerRow layer;
  layer.layer = 0;
  layer.mean_mm = 0.2;
  ExecutionLog(journal).setLayer(execution, layer);
  journal.end(execution, JobState::Ended, "", 4.0);
  keepRecord(journal, store, execution, {"good", 5.0, {}});
  return partRecord(journal, execution, {"good", 5.0, {}});
}

TEST(OperatorSite, ReadsTheRecordOfAPartToViewersAndNotToSenders) {
  SiteOfFakes site(closedLoopback());
  const std::string folder = site.folder.path();
  const PartRecord made = makePart(folder);
  const std::string& layers_csv = made.layers_csv;
  const Headers viewer = {{"x-api-key", site.add(WebRole::Viewer, "wall")}};
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/jobs/1/record", viewer).body, made.json);
  const WebResponse layers = site.ask(HttpMethod::Get, "/api/v1/jobs/1/layers", viewer);
  EXPECT_EQ(layers.body, layers_csv);
  EXPECT_EQ(layers.type, "text/csv; charset=utf-8");
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/jobs/2/record", viewer).status, 404);
  const Headers sender = {{"x-api-key", site.add(WebRole::Sender, "slicer")}};
  for (const char* what : {"record", "layers"})
    EXPECT_EQ(site.ask(HttpMethod::Get, std::string("/api/v1/jobs/1/") + what, sender).status, 403);
  const std::string path =
      ArtefactStore::toRead(folder + "/artefacts").pathOf({sha256Of(layers_csv), 0, "layers", "layers.csv"});
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  std::ofstream(path) << "changed";
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/jobs/1/layers", viewer).status, 500);
}

TEST(OperatorSite, ListsThePartsThatWereMade) {
  SiteOfFakes site(closedLoopback());
  const std::string viewer = site.add(WebRole::Viewer, "wall");
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/records", {{"x-api-key", viewer}}).status, 404)
      << "no journal";
  makePart(site.folder.path());
  const nlohmann::json records = site.get("/api/v1/records", viewer)["records"];
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0]["job"], 1);
  EXPECT_EQ(records[0]["name"], "part.gcode");
  EXPECT_EQ(records[0]["part"], "bracket");
  EXPECT_EQ(records[0]["verdict"], "good");
  EXPECT_EQ(records[0]["operator"], "anna");
  EXPECT_EQ(records[0]["started_utc_s"], 3.0);
  EXPECT_EQ(records[0]["ended_utc_s"], 4.0);
  const Headers sender = {{"x-api-key", site.add(WebRole::Sender, "slicer")}};
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/records", sender).status, 403);
}

TEST(OperatorSite, QueuesTheProgramOfAJobOnceMore) {
  SiteOfFakes site(closedLoopback());
  const std::string folder = site.folder.path();
  const Headers anna = {{"x-api-key", site.add(WebRole::Operator, "anna")}};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/1/again", anna).status, 404) << "no journal yet";
  makePart(folder);
  const Headers viewer = {{"x-api-key", site.add(WebRole::Viewer, "wall")}};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/1/again", viewer).status, 403);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/2/again", anna).status, 404);
  EXPECT_TRUE(site.desk.orders().empty());

  const WebResponse answer = site.ask(HttpMethod::Post, "/api/v1/jobs/1/again", anna);
  EXPECT_EQ(answer.status, 201);
  EXPECT_EQ(nlohmann::json::parse(answer.body)["job"], 7);
  EXPECT_EQ(site.desk.orders(), (std::vector<std::string>{"enqueue part.gcode by page: anna"}));
  EXPECT_EQ(site.desk.uploaded, "G28\n");
  EXPECT_EQ(site.lastAudit(), "anna | POST /api/v1/jobs/1/again: job 1 once more | done 201");

  const std::string path =
      ArtefactStore::toRead(folder + "/artefacts").pathOf({sha256Of("G28\n"), 0, "program", "part.gcode"});
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  std::ofstream(path) << "changed";
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/1/again", anna).status, 404);
  EXPECT_EQ(site.desk.orders().size(), 1U);
}

}  // namespace
}  // namespace lamina::test
