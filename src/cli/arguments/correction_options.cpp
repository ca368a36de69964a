// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/correction_options.hpp"

#include <filesystem>
#include <utility>

#include "lamina/base/atomic_file.hpp"

namespace lamina::cli {
namespace {

/// Maps lie beside the toolpath they are of.
std::string toolpathBeside(const std::string& maps) {
  const std::filesystem::path path(maps);
  return ((std::filesystem::is_directory(path) ? path : path.parent_path()) / kProgrammedToolpathFile)
      .string();
}

}  // namespace

void addToolpathOption(CLI::App& subcommand, CorrectionOptions& options) {
  subcommand.add_option("--toolpath", options.toolpath,
                        "toolpath (.csv) that the maps are of, as it stands beside maps; without it, "
                        "toolpath.csv beside these");
}

PlannedCorrection correctionFrom(const CorrectionOptions& options, const LoopSettings& feeding,
                                 const std::string& program_sha256) {
  const std::string toolpath = options.toolpath.empty() ? toolpathBeside(options.maps) : options.toolpath;
  std::vector<FiledMap> maps = readCorrectionFiles(options.maps);
  PlannedCorrection correction{readProgrammedToolpath(readFile(toolpath), toolpath), std::move(maps),
                               feeding};
  const std::optional<RecordedJob> recorded = recordedJob(options.maps);
  correction.is_recorded_program = recorded && recorded->program_sha256 == program_sha256;
  requireOfProgram(correction);
  return correction;
}

}  // namespace lamina::cli
