// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <optional>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/sha256.hpp"
#include "lamina/journal/part_record.hpp"
#include "web/site_routes.hpp"

namespace lamina {
namespace {

using nlohmann::json;

/// The bytes of an artefact.
/// @throws FileError if it is gone, or no longer has its digest
std::string bytesOf(const ArtefactStore& store, const Artefact& artefact) {
  std::string bytes = readFile(store.pathOf(artefact));
  const std::string digest = sha256Of(bytes);
  if (digest != artefact.sha256)
    throw FileError(artefact.name + " was changed: its SHA-256 is " + digest + "; expected " +
                    artefact.sha256);
  return bytes;
}

constexpr std::size_t kMostRecords = 100;

/// The cell's journal, to read; nothing where the page's folder holds none.
std::optional<CellJournal> journalOf(const SiteCall& call) {
  const std::string& folder = call.parts.settings.journal_folder;
  const std::string path = folder + "/cell.db";
  if (folder.empty() || !std::filesystem::exists(path)) return std::nullopt;
  return CellJournal::read(path);
}

std::string artefactsOf(const SiteCall& call) { return call.parts.settings.journal_folder + "/artefacts"; }

/// The record of the part that a job has made last. The files that it names are not read: programs are
/// large, and `lamina record` checks them.
std::optional<std::string> recordOf(const SiteCall& call, std::int64_t job) {
  auto journal = journalOf(call);
  if (!journal) return std::nullopt;
  const ExecutionLog log(*journal);
  const auto execution = log.ofJob(job);
  const auto part = execution ? log.part(execution->id) : std::nullopt;
  if (!part) return std::nullopt;
  return bytesOf(ArtefactStore::toRead(artefactsOf(call)), part->record);
}

WebResponse noRecord(const SiteCall& call) {
  return errorAnswer(404, "unknown",
                     "job " + call.value(0) +
                         " has no record: it has not ended, is not known, or the "
                         "journal is not in the folder of the page");
}

WebResponse getRecord(SiteCall& call) {
  const auto record = recordOf(call, jobNumber(call.value(0)));
  if (!record) return noRecord(call);
  WebResponse response;
  response.body = *record;
  return response;
}

WebResponse getJobLayers(SiteCall& call) {
  const auto record = recordOf(call, jobNumber(call.value(0)));
  if (!record) return noRecord(call);
  const json value = json::parse(*record, nullptr, false);
  const json layers = value.is_object() ? value.value("layers", json::object()) : json::object();
  WebResponse response;
  response.type = "text/csv; charset=utf-8";
  response.body = bytesOf(ArtefactStore::toRead(artefactsOf(call)),
                          {textOf(layers, "sha256"), 0, "layers", "layers.csv"});
  return response;
}

json partJson(const QueuedJob& job, const ExecutionRow& execution, const PartRow& part) {
  return {{"job", job.id},
          {"name", job.name},
          {"part", job.part},
          {"serial", part.serial},
          {"verdict", part.verdict},
          {"reason", execution.reason},
          {"operator", execution.operator_name},
          {"started_utc_s", execution.started_s},
          {"ended_utc_s", execution.ended_s ? json(*execution.ended_s) : json(nullptr)}};
}

/// Parts that were made, the latest first.
WebResponse getRecords(SiteCall& call) {
  auto journal = journalOf(call);
  if (!journal) return errorAnswer(404, "unknown", "the journal is not in the folder of the page");
  const ExecutionLog log(*journal);
  json parts = json::array();
  for (const std::int64_t id : log.withPart(kMostRecords)) {
    const ExecutionRow execution = log.execution(id);
    parts.push_back(partJson(journal->job(execution.job), execution, *log.part(id)));
  }
  return jsonAnswer(200, {{"records", parts}});
}

std::optional<Artefact> fileOf(const QueuedJob& job, const std::string& kind) {
  const auto found = std::find_if(job.artefacts.begin(), job.artefacts.end(),
                                  [&kind](const Artefact& file) { return file.kind == kind; });
  return found == job.artefacts.end() ? std::nullopt : std::optional<Artefact>(*found);
}

/// A job, also one that has ended.
std::optional<QueuedJob> jobIn(const CellJournal& journal, std::int64_t id) {
  try {
    return journal.job(id);
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

/// The program of a job is checked and queued as one that is sent: the machine may be another by now.
WebResponse printAgain(SiteCall& call) {
  const std::int64_t number = jobNumber(call.value(0));
  const auto journal = journalOf(call);
  const auto job = journal ? jobIn(*journal, number) : std::nullopt;
  if (!job)
    return errorAnswer(
        404, "unknown",
        "job " + call.value(0) + " is not known, or the journal is not in the folder of the page");
  const ArtefactStore store = ArtefactStore::toRead(artefactsOf(call));
  const auto program = fileOf(*job, "program");
  if (!program || !store.torn({*program}).empty())
    return errorAnswer(404, "unknown",
                       "the program of job " + call.value(0) + " is no longer as it was in the cell's store");
  DeskProgram again{store.pathOf(*program), job->name, job->part, call.source()};
  const auto mesh = fileOf(*job, "mesh");
  if (mesh && store.torn({*mesh}).empty()) {
    again.mesh = store.pathOf(*mesh);
    again.mesh_name = mesh->name;
  }
  const DeskAnswer answer = call.parts.desk.enqueue(again);
  WebResponse response = answer.outcome == DeskAnswer::Outcome::Done
                             ? jsonAnswer(201, {{"job", answer.job}, {"name", job->name}})
                             : orderAnswer(call, answer);
  response.note = "job " + call.value(0) + " once more";
  return response;
}

/// What a person says of the last part of a job.
WebResponse judge(SiteCall& call) {
  const json body = bodyObject(call);
  const DeskVerdict verdict{jobNumber(call.value(0)), textOf(body, "verdict"), call.source(),
                            textOf(body, "reason")};
  if (verdict.verdict != "good" && verdict.verdict != "scrap" && verdict.verdict != "rework")
    throw InvalidInput("verdict is '" + verdict.verdict + "'; expected good, scrap or rework");
  WebResponse response = orderAnswer(call, call.parts.desk.judge(verdict));
  response.note = "job " + call.value(0) + " is " + verdict.verdict;
  return response;
}

}  // namespace

std::vector<SiteRoute> partRoutes() {
  return {
      {{HttpMethod::Get, "/api/v1/records", WebRight::SeeAll, RouteBody::None}, getRecords},
      {{HttpMethod::Post, "/api/v1/jobs/{id}/again", WebRight::Operate, RouteBody::Small}, printAgain},
      {{HttpMethod::Post, "/api/v1/jobs/{id}/verdict", WebRight::Operate, RouteBody::Small}, judge},
      {{HttpMethod::Get, "/api/v1/jobs/{id}/layers", WebRight::SeeAll, RouteBody::None}, getJobLayers},
      {{HttpMethod::Get, "/api/v1/jobs/{id}/record", WebRight::SeeAll, RouteBody::None}, getRecord},
  };
}

}  // namespace lamina
