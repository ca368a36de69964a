// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina {

/// What a firmware takes besides motions. Numbers in braces are put in by `dialectLine`.
struct GcodeDialect {
  std::string name;          ///< the flavour, as `program.flavour` gives it
  bool has_extruder = true;  ///< E words; without them what deposits is switched by code of the machine
  bool has_heaters = true;
  bool has_fan = true;
  bool has_pause = true;
  bool has_tools = true;
  bool dwells_in_seconds = false;  ///< the unit of G4 P; else ms
  std::string progress;            ///< {percent}, {minutes} left; empty if there is none
  std::string accelerations;       ///< {deposit}, {travel} [mm/s²]; empty if there is none
};

/// The dialects that `writeGcode` writes: marlin, klipper, reprapfirmware, grbl.
const std::vector<GcodeDialect>& gcodeDialects();

/// The dialect of that name; Marlin's if the flavour has none of its own (fullcontrol, plug-ins).
const GcodeDialect& gcodeDialect(const std::string& name);

/// A word of a dialect's command that stands for a number.
struct DialectWord {
  std::string name;
  long long value = 0;
};

/// The command with its placeholders replaced, its line ended.
std::string dialectLine(std::string command, const std::vector<DialectWord>& words);

}  // namespace lamina
