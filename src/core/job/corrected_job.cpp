// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/corrected_job.hpp"

#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/streaming/journal/job_journal.hpp"

namespace lamina {
namespace {

/// Maps lie beside the toolpath they are of.
std::string toolpathBeside(const std::string& maps) {
  const std::filesystem::path path(maps);
  return ((std::filesystem::is_directory(path) ? path : path.parent_path()) / kProgrammedToolpathFile)
      .string();
}

std::string wholeTextOf(const StreamableProgram& program) {
  const auto text = program.openText();
  return {std::istreambuf_iterator<char>(*text), {}};
}

}  // namespace

PlannedCorrection correctionFrom(const CorrectionFiles& files, const LoopSettings& feeding,
                                 const std::string& program_sha256) {
  const std::string toolpath = files.toolpath.empty() ? toolpathBeside(files.maps) : files.toolpath;
  std::vector<FiledMap> maps = readCorrectionFiles(files.maps);
  PlannedCorrection correction{readProgrammedToolpath(readTextFile(toolpath), toolpath), std::move(maps),
                               feeding};
  const std::optional<RecordedJob> recorded = recordedJob(files.maps);
  correction.is_recorded_program = recorded && recorded->program_sha256 == program_sha256;
  requireOfProgram(correction);
  return correction;
}

StreamableProgram programByMaps(const StreamableProgram& planned, const CorrectionFiles& files,
                                const PlannedCorrection& correction, const StreamSettings& settings) {
  ProgramOrigin origin{sha256Of(planned), {}};
  if (const auto recorded = recordedJob(files.maps))
    origin.record = RevisionRecord{std::filesystem::absolute(files.maps).string(), recorded->job,
                                   feedingText(correction.feeding)};
  for (const FiledMap& each : correction.maps) origin.maps.push_back({each.map.layer, digestOf(each.map)});
  std::string corrected = correctedByMaps(planned.name(), wholeTextOf(planned), correction).text;
  return StreamableProgram::fromText(planned.name(), std::move(corrected), settings)
      .madeFrom(std::move(origin));
}

}  // namespace lamina
