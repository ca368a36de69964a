// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/gcode_dialect.hpp"

#include <map>

#include "lamina/program/gcode/full_control_writer.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"

namespace lamina {
namespace {

GcodeDialect marlin() {
  GcodeDialect dialect;
  dialect.write = writeGcode;
  dialect.progress = "M73 P{percent} R{minutes}";
  dialect.accelerations = "M204 P{deposit} T{travel}";
  dialect.advance = "marlin";
  dialect.labels = "m486";
  return dialect;
}

/// Klipper has one acceleration for all motions.
GcodeDialect klipper() {
  GcodeDialect dialect;
  dialect.write = writeGcode;
  dialect.progress = "M73 P{percent}";
  dialect.accelerations = "SET_VELOCITY_LIMIT ACCEL={deposit}";
  dialect.pause = "PAUSE";
  dialect.advance = "klipper";
  dialect.labels = "exclude_object";
  return dialect;
}

/// M0 ends a program, and M226 is known in files on the card alone. S of M106 is a share up to 1, which is
/// all of the fan.
GcodeDialect repRapFirmware() {
  GcodeDialect dialect = marlin();
  dialect.pause = "M291";
  dialect.advance = "reprapfirmware";
  dialect.least_fan = 2;
  return dialect;
}

GcodeDialect grbl() {
  GcodeDialect dialect;
  dialect.write = writeGcode;
  dialect.has_extruder = dialect.has_heaters = dialect.has_fan = dialect.has_pause = dialect.has_tools =
      false;
  dialect.dwells_in_seconds = true;
  return dialect;
}

/// Its published listings hold neither waits nor fans.
GcodeDialect fullControl() {
  GcodeDialect dialect = marlin();
  dialect.write = writeFullControl;
  dialect.has_waits = dialect.has_fan = false;
  return dialect;
}

}  // namespace

Registry<GcodeDialect>& gcodeDialects() {
  static Registry<GcodeDialect> registry("program.dialect", {{"marlin", marlin()},
                                                             {"klipper", klipper()},
                                                             {"reprapfirmware", repRapFirmware()},
                                                             {"grbl", grbl()},
                                                             {"fullcontrol", fullControl()}});
  return registry;
}

void writeInDialect(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                    const TextSink& sink) {
  gcodeDialects().find(settings.dialect).write(toolpath, frame, settings, sink);
}

std::string dialectLine(std::string command, const std::vector<DialectWord>& words) {
  for (const DialectWord& word : words) {
    const std::string placeholder = "{" + word.name + "}";
    const std::string value = std::to_string(word.value);
    for (std::size_t at = command.find(placeholder); at != std::string::npos;
         at = command.find(placeholder, at + value.size()))
      command.replace(at, placeholder.size(), value);
  }
  return command + "\n";
}

}  // namespace lamina
