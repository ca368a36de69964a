// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/rapid_files.hpp"

#include <deque>
#include <filesystem>
#include <optional>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/program/rapid/writer/rapid_writer.hpp"

namespace lamina {
namespace {

void requireBedAxes(const ProgramFrame& frame) {
  if (!frame.program_from_bed.matrix().isIdentity(0.0))
    throw InvalidInput(
        "the machine's axes stand askew to its bed; a program for a robot reports coordinates of the bed, "
        "expected a machine whose axes are at right angles");
}

std::optional<RobotMotion> motionOf(const PlacedToolpath& placed) {
  if (!placed.joints) return std::nullopt;
  return RobotMotion{placed.joints->model, placed.joints->path};
}

}  // namespace

bool isRapidFile(const std::string& path) { return smallSuffix(path) == ".mod"; }

void writeRapid(const PlacedToolpath& placed, const RapidSettings& settings, const TextSink& sink) {
  requireBedAxes(placed.frame);
  const auto motion = motionOf(placed);
  writeRapid(placed.toolpath, placed.frame.bed_from_part, settings, sink, motion ? &*motion : nullptr);
}

std::vector<std::string> writeRapidFiles(const std::string& path, const PlacedToolpath& placed,
                                         RapidSettings settings) {
  requireBedAxes(placed.frame);
  const std::filesystem::path main(path);
  if (settings.module.empty()) settings.module = main.stem().string();
  const auto motion = motionOf(placed);
  const RapidProgram program(placed.toolpath, placed.frame.bed_from_part, settings,
                             motion ? &*motion : nullptr);
  std::vector<std::string> names;
  names.reserve(program.moduleNames().size());
  std::deque<AtomicFile> files;
  for (std::size_t m = 0; m < program.moduleNames().size(); ++m) {
    const std::string name = program.moduleNames()[m] + ".mod";
    if (m > 0 && name == main.filename().string())
      throw InvalidConfig("the module '" + program.moduleNames()[m] + "' would be written over the file '" +
                          path + "', which is to hold '" + settings.module +
                          "'; expected another rapid.module");
    names.push_back(m == 0 ? main.filename().string() : name);
    AtomicFile& file = files.emplace_back(m == 0 ? path : (main.parent_path() / name).string());
    program.write(m, [&file](std::string_view piece) { file.write(piece); });
  }
  // Main last: it names the others.
  for (auto file = files.rbegin(); file != files.rend(); ++file) file->commit();
  return names;
}

}  // namespace lamina
