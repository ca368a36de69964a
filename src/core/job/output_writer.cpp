// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/output_writer.hpp"

#include <filesystem>
#include <map>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/program/csv_writer.hpp"
#include "lamina/program/gcode_writer.hpp"

namespace lamina {
namespace {

std::map<std::string, OutputWriter> registry() {
  return {
      {".csv", [](const PlacedToolpath& placed, const ProgramSettings&,
                  const TextSink& sink) { writeCsv(placed.toolpath, sink); }},
      {".gcode", [](const PlacedToolpath& placed, const ProgramSettings& settings,
                    const TextSink& sink) { writeGcode(placed.toolpath, placed.frame, settings, sink); }},
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
  AtomicFile file(path);
  write(placed, settings, [&file](std::string_view piece) { file.write(piece); });
  file.commit();
}

}  // namespace lamina
