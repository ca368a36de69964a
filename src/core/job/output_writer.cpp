// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/output_writer.hpp"

#include <filesystem>
#include <map>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/job/rapid_files.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "lamina/program/five_axis/five_axis_writer.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"

namespace lamina {
namespace {

void writeProgram(const PlacedToolpath& placed, const ProgramSettings& settings, const TextSink& sink) {
  if (!placed.joints) return writeGcode(placed.toolpath, placed.frame, settings, sink);
  const FiveAxisMotion motion{placed.toolpath, placed.frame.bed_from_part, placed.joints->model,
                              placed.joints->path};
  writeFiveAxis(motion, settings.five_axis, settings, sink);
}

std::map<std::string, OutputWriter> registry() {
  return {
      {".csv", [](const PlacedToolpath& placed, const ProgramSettings&,
                  const TextSink& sink) { writeCsv(placed.toolpath, sink); }},
      {".gcode", writeProgram},
      {".mod", [](const PlacedToolpath& placed, const ProgramSettings& settings,
                  const TextSink& sink) { writeRapid(placed, settings.rapid, sink); }},
  };
}

}  // namespace

std::vector<std::string> outputSuffixes() {
  std::vector<std::string> suffixes;
  for (const auto& entry : registry()) suffixes.push_back(entry.first);
  return suffixes;
}

OutputWriter outputWriterFor(const std::string& path) {
  const auto writers = registry();
  const auto found = writers.find(std::filesystem::path(path).extension().string());
  if (found != writers.end()) return found->second;
  throw InvalidInput("output '" + path + "' has no suffix that chooses a writer; must be one of " +
                     listed(outputSuffixes()));
}

void writeOutput(const std::string& path, const PlacedToolpath& placed, const ProgramSettings& settings) {
  const OutputWriter write = outputWriterFor(path);
  if (isRapidFile(path)) return writeRapidFiles(path, placed, settings.rapid);
  AtomicFile file(path);
  write(placed, settings, [&file](std::string_view piece) { file.write(piece); });
  file.commit();
}

}  // namespace lamina
