// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/gcode_flavour.hpp"

#include "lamina/program/gcode/full_control_writer.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"

namespace lamina {

Registry<GcodeFlavour>& gcodeFlavours() {
  static Registry<GcodeFlavour> registry("program.flavour",
                                         {{"fullcontrol", writeFullControl}, {"marlin", writeGcode}});
  return registry;
}

void writeFlavoured(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                    const TextSink& sink) {
  gcodeFlavours().find(settings.flavour)(toolpath, frame, settings, sink);
}

}  // namespace lamina
