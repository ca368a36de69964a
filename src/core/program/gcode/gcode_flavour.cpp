// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/gcode_flavour.hpp"

#include <map>

#include "lamina/program/gcode/full_control_writer.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"

namespace lamina {
namespace {

std::map<std::string, GcodeFlavour> flavours() {
  std::map<std::string, GcodeFlavour> flavours = {{"fullcontrol", writeFullControl}};
  for (const GcodeDialect& dialect : gcodeDialects()) flavours[dialect.name] = writeGcode;
  return flavours;
}

}  // namespace

Registry<GcodeFlavour>& gcodeFlavours() {
  static Registry<GcodeFlavour> registry("program.flavour", flavours());
  return registry;
}

void writeFlavoured(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                    const TextSink& sink) {
  gcodeFlavours().find(settings.flavour)(toolpath, frame, settings, sink);
}

}  // namespace lamina
