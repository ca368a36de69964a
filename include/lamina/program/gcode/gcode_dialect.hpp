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

/// Writes a toolpath as G-code of linear axes, in the coordinates that the frame's axes give. What it
/// refuses, it refuses before the first piece is written.
/// @throws InvalidInput, InvalidConfig as `writeGcode`
using GcodeDialectWriter = std::function<void(const Toolpath& toolpath, const ProgramFrame& frame,
                                              const ProgramSettings& settings, const TextSink& sink)>;

/// Who writes a dialect of G-code, and what its firmware understands besides motions: what it does not is not
/// planned for it. Numbers in braces are put in by `dialectLine`.
struct GcodeDialect {
  GcodeDialectWriter write;
  bool has_waits = true;     ///< while cooling
  bool has_extruder = true;  ///< E words; without them what deposits is switched by code of the machine
  bool has_heaters = true;
  bool has_fan = true;
  bool has_pause = true;
  bool has_tools = true;
  bool dwells_in_seconds = false;  ///< the unit of G4 P; else ms
  std::string progress;            ///< {percent}, {minutes} left; empty if there is none
  std::string accelerations;       ///< {deposit}, {travel} [mm/s²]; empty if there is none
};

/// All dialects by name, those of plug-ins too: "marlin", "klipper", "reprapfirmware", "grbl" (`writeGcode`),
/// "fullcontrol" (`writeFullControl`). Whoever adds one calls `gcodeDialects().add("name", {write})`.
Registry<GcodeDialect>& gcodeDialects();

/// Writes in the dialect that `program.dialect` names.
/// @throws InvalidConfig if there is none of that name; as the dialect's writer
void writeInDialect(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                    const TextSink& sink);

/// A placeholder in a command of a dialect, and the number that replaces it.
struct DialectWord {
  std::string name;
  long long value = 0;
};

/// The command with its placeholders replaced, its line ended.
std::string dialectLine(std::string command, const std::vector<DialectWord>& words);

}  // namespace lamina
