// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/gcode_dialect.hpp"

#include <algorithm>
#include <map>

#include "lamina/program/gcode/full_control_writer.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"

namespace lamina {
namespace {

GcodeDialect marlin() {
  GcodeDialect dialect;
  dialect.name = "marlin";
  dialect.progress = "M73 P{percent} R{minutes}";
  dialect.accelerations = "M204 P{deposit} T{travel}";
  return dialect;
}

/// Klipper has one acceleration for all motions.
GcodeDialect klipper() {
  GcodeDialect dialect;
  dialect.name = "klipper";
  dialect.progress = "M73 P{percent}";
  dialect.accelerations = "SET_VELOCITY_LIMIT ACCEL={deposit}";
  return dialect;
}

GcodeDialect repRapFirmware() {
  GcodeDialect dialect = marlin();
  dialect.name = "reprapfirmware";
  return dialect;
}

GcodeDialect grbl() {
  GcodeDialect dialect;
  dialect.name = "grbl";
  dialect.has_extruder = dialect.has_heaters = dialect.has_fan = dialect.has_pause = dialect.has_tools =
      false;
  dialect.dwells_in_seconds = true;
  return dialect;
}

const std::vector<GcodeDialect>& firmwareDialects() {
  static const std::vector<GcodeDialect> dialects = {marlin(), klipper(), repRapFirmware(), grbl()};
  return dialects;
}

std::map<std::string, GcodeDialectWriter> dialectWriters() {
  std::map<std::string, GcodeDialectWriter> writers = {{"fullcontrol", writeFullControl}};
  for (const GcodeDialect& dialect : firmwareDialects()) writers[dialect.name] = writeGcode;
  return writers;
}

}  // namespace

Registry<GcodeDialectWriter>& gcodeDialects() {
  static Registry<GcodeDialectWriter> registry("program.dialect", dialectWriters());
  return registry;
}

void writeInDialect(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                    const TextSink& sink) {
  gcodeDialects().find(settings.dialect)(toolpath, frame, settings, sink);
}

const GcodeDialect& gcodeDialect(const std::string& name) {
  const std::vector<GcodeDialect>& dialects = firmwareDialects();
  const auto found = std::find_if(dialects.begin(), dialects.end(),
                                  [&](const GcodeDialect& dialect) { return dialect.name == name; });
  return found == dialects.end() ? dialects.front() : *found;
}

std::string dialectLine(std::string command, const std::vector<DialectWord>& words) {
  for (const DialectWord& word : words) {
    const std::string placeholder = "{" + word.name + "}";
    const std::size_t at = command.find(placeholder);
    if (at != std::string::npos) command.replace(at, placeholder.size(), std::to_string(word.value));
  }
  return command + "\n";
}

}  // namespace lamina
