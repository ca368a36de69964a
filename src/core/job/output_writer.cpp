// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/output_writer.hpp"

#include <filesystem>
#include <map>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/job/rapid_files.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "lamina/program/five_axis/five_axis_writer.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"

namespace lamina {
namespace {

void writeProgram(const PlacedToolpath& placed, const ProgramSettings& settings, const TextSink& sink) {
  if (!placed.joints) return writeInDialect(placed.toolpath, placed.frame, settings, sink);
  const FiveAxisMotion motion{placed.toolpath, placed.frame.bed_from_part, placed.joints->model,
                              placed.joints->path};
  writeFiveAxis(motion, settings.five_axis, settings, sink);
}

ProgramWriter robotWriter(RobotLanguage language) {
  ProgramWriter robot;
  robot.write = [language](const PlacedToolpath& placed, const ProgramSettings& settings,
                           const TextSink& sink) {
    writeRobotProgram(language, placed, settings.robot, sink);
  };
  robot.write_files = [](const std::string& path, const PlacedToolpath& placed,
                         const ProgramSettings& settings) { writeRobotFiles(path, placed, settings.robot); };
  return robot;
}

std::map<std::string, ProgramWriter> builtInWriters() {
  ProgramWriter csv;
  csv.write = [](const PlacedToolpath& placed, const ProgramSettings&, const TextSink& sink) {
    writeCsv(placed.toolpath, sink);
  };
  ProgramWriter rapid;
  rapid.write = [](const PlacedToolpath& placed, const ProgramSettings& settings, const TextSink& sink) {
    writeRapid(placed, rapidWithLoad(settings), sink);
  };
  rapid.write_files = [](const std::string& path, const PlacedToolpath& placed,
                         const ProgramSettings& settings) {
    writeRapidFiles(path, placed, rapidWithLoad(settings));
  };
  std::map<std::string, ProgramWriter> writers = {
      {".csv", csv}, {".gcode", {writeProgram, {}}}, {".mod", rapid}};
  for (const RobotLanguage language : kRobotLanguages)
    writers.emplace(suffixOf(language), robotWriter(language));
  return writers;
}

/// @throws InvalidInput if the suffix chooses none
ProgramWriter programWriterFor(const std::string& path) {
  const std::string suffix = std::filesystem::path(path).extension().string();
  if (programWriters().has(suffix)) return programWriters().find(suffix);
  throw InvalidInput("output '" + path + "' has no suffix that chooses a writer; must be one of " +
                     listed(outputSuffixes()));
}

}  // namespace

Registry<ProgramWriter>& programWriters() {
  static Registry<ProgramWriter> registry("the output's suffix", builtInWriters());
  return registry;
}

std::vector<std::string> outputSuffixes() { return programWriters().names(); }

OutputWriter outputWriterFor(const std::string& path) { return programWriterFor(path).write; }

void writeOutput(const std::string& path, const PlacedToolpath& placed, const ProgramSettings& settings) {
  writeOutput(path, placed, settings, {});
}

void writeOutput(const std::string& path, const PlacedToolpath& placed, const ProgramSettings& settings,
                 const ProgramAnnotations& annotations) {
  const ProgramWriter writer = programWriterFor(path);
  if (writer.write_files) return writer.write_files(path, placed, settings);
  AtomicFile file(path);
  writeAnnotated(
      annotations, [&](const TextSink& sink) { writer.write(placed, settings, sink); },
      [&file](std::string_view piece) { file.write(piece); });
  file.commit();
}

}  // namespace lamina
