// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lamina/base/registry.hpp"
#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A function that writes a toolpath as G-code of linear axes, in the coordinates of `frame`. It checks
/// everything before it writes the first piece.
/// @throws InvalidInput, InvalidConfig as `writeGcode`
using GcodeDialectWriter = std::function<void(const Toolpath& toolpath, const ProgramFrame& frame,
                                              const ProgramSettings& settings, const TextSink& sink)>;

/// A dialect of G-code: its writer, and the commands that its firmware has besides motions. Nothing is
/// planned for which the firmware has no command. Placeholders in braces are replaced by `dialectLine`.
struct GcodeDialect {
  GcodeDialectWriter write;
  bool has_waits = true;     ///< dwells (G4), which give short layers time to cool
  bool has_extruder = true;  ///< E words; without them the machine's own code switches the process
  bool has_heaters = true;
  bool has_fan = true;
  bool has_pause = true;
  bool has_tools = true;
  bool dwells_in_seconds = false;  ///< whether P in G4 is in seconds; otherwise in ms
  std::string pause = "M0";        ///< command that waits for the operator
  std::string progress;       ///< command that reports {percent} done, {minutes} left; empty if there is none
  std::string accelerations;  ///< command that sets {deposit}, {travel} [mm/s²]; empty if there is none
  std::string advance;        ///< value of `flow.advance_word` for its firmware; empty if it takes none
  std::string labels;         ///< value of `plate.labels` that its firmware takes; empty if it takes none
  int least_fan = 1;  ///< least S of M106 that the firmware counts in 255ths; below it, S is a share up to 1
};

/// All dialects by name, those of plug-ins included: "marlin", "klipper", "reprapfirmware", "grbl"
/// (`writeGcode`), "fullcontrol" (`writeFullControl`). A plug-in adds one by `gcodeDialects().add("name",
/// {write})`.
Registry<GcodeDialect>& gcodeDialects();

/// Writes a toolpath in the dialect that `program.dialect` names.
/// @throws InvalidConfig if there is no dialect of that name; also what its writer throws
void writeInDialect(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                    const TextSink& sink);

/// A placeholder in a command of a dialect, and the number that replaces it.
struct DialectWord {
  std::string name;
  long long value = 0;
};

/// The command with every occurrence of each placeholder replaced, and with a line feed at its end.
std::string dialectLine(std::string command, const std::vector<DialectWord>& words);

}  // namespace lamina
