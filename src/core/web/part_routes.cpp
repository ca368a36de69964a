// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

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

/// The record of the part that a job has made last. The files that it names are not read: programs are
/// large, and `lamina record` checks them.
std::optional<std::string> recordOf(const std::string& folder, std::int64_t job) {
  const std::string path = folder + "/cell.db";
  if (folder.empty() || !std::filesystem::exists(path)) return std::nullopt;
  CellJournal journal = CellJournal::read(path);
  const ExecutionLog log(journal);
  const auto execution = log.ofJob(job);
  const auto part = execution ? log.part(execution->id) : std::nullopt;
  if (!part) return std::nullopt;
  return bytesOf(ArtefactStore::toRead(folder + "/artefacts"), part->record);
}

WebResponse noRecord(const SiteCall& call) {
  return errorAnswer(404, "unknown",
                     "job " + call.value(0) +
                         " has no record: it has not ended, is not known, or the "
                         "journal is not in the folder of the page");
}

WebResponse getRecord(SiteCall& call) {
  const auto record = recordOf(call.parts.settings.journal_folder, jobNumber(call.value(0)));
  if (!record) return noRecord(call);
  WebResponse response;
  response.body = *record;
  return response;
}

WebResponse getJobLayers(SiteCall& call) {
  const std::string& folder = call.parts.settings.journal_folder;
  const auto record = recordOf(folder, jobNumber(call.value(0)));
  if (!record) return noRecord(call);
  const json value = json::parse(*record, nullptr, false);
  const json layers = value.is_object() ? value.value("layers", json::object()) : json::object();
  WebResponse response;
  response.type = "text/csv; charset=utf-8";
  response.body = bytesOf(ArtefactStore::toRead(folder + "/artefacts"),
                          {textOf(layers, "sha256"), 0, "layers", "layers.csv"});
  return response;
}

}  // namespace

std::vector<SiteRoute> partRoutes() {
  return {
      {{HttpMethod::Get, "/api/v1/jobs/{id}/layers", WebRight::SeeAll, RouteBody::None}, getJobLayers},
      {{HttpMethod::Get, "/api/v1/jobs/{id}/record", WebRight::SeeAll, RouteBody::None}, getRecord},
  };
}

}  // namespace lamina
