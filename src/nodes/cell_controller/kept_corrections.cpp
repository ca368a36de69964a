// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kept_corrections.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "lamina/control/program/correction_files.hpp"

namespace lamina {
namespace {

constexpr double kSameTime = 2.0;  // s: file systems and clocks of a host agree to that

/// UTC [s]; nothing without the file.
std::optional<double> writtenAt(const std::string& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return std::nullopt;
  return static_cast<double>(found.st_mtim.tv_sec) + 1e-9 * static_cast<double>(found.st_mtim.tv_nsec);
}

/// The record of a job before this one is left where this one has failed before its first line.
bool isOf(const std::string& folder, const QueuedJob& job, const ExecutionRow& execution) {
  const auto written_s = writtenAt(folder + '/' + kAppliedMapsFile);
  if (!written_s || *written_s < execution.started_s - kSameTime) return false;
  if (execution.ended_s && *written_s > *execution.ended_s + kSameTime) return false;
  const auto recorded = recordedJob(folder);
  return recorded && std::any_of(job.artefacts.begin(), job.artefacts.end(), [&](const Artefact& artefact) {
           return artefact.kind == "program" && artefact.sha256 == recorded->program_sha256;
         });
}

}  // namespace

std::vector<Artefact> keptCorrections(ArtefactStore& store, const std::string& folder, const QueuedJob& job,
                                      const ExecutionRow& execution) {
  if (folder.empty() || !isOf(folder, job, execution)) return {};
  std::vector<std::string> names = {kAppliedMapsFile, kProgrammedToolpathFile};
  for (const FiledMap& map : readCorrectionFiles(folder))
    names.push_back(std::filesystem::path(map.file).filename().string());
  std::sort(names.begin(), names.end());
  std::vector<Artefact> kept;
  kept.reserve(names.size());
  for (const std::string& name : names) kept.push_back(store.keep(folder + '/' + name, "correction", name));
  return kept;
}

}  // namespace lamina
