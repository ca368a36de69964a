// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Meaning of the axis words in a five-axis program.
enum class FiveAxisCoordinates : std::uint8_t {
  /// Position of the tip over the bed, and values of rotary joints; the controller moves the linear joints
  /// (RTCP).
  ToolTip,
  Joints,  ///< values of all joints, with inverse-time feed (G93)
};

/// Controller for which a program is written. It decides the commands for tool-tip coordinates, material
/// feed, waits and the end of the program.
enum class FiveAxisDialect : std::uint8_t { Generic, LinuxCnc, Fanuc, Siemens };

/// Meaning of the words of rotary joints that turn without end.
enum class FiveAxisTurns : std::uint8_t {
  Counted,  ///< whole turns, from the start on
  Modulo,   ///< the angle within one turn; each line rotates by the smaller angle
};

/// Which toolpaths are written as five-axis G-code.
enum class FiveAxisUse : std::uint8_t {
  Tilted,  ///< toolpaths that the linear axes alone cannot run
  Always,  ///< level toolpaths too
};

/// How a toolpath is written as G-code for a machine that rotates its nozzle or its table.
struct FiveAxisSettings {
  FiveAxisUse use = FiveAxisUse::Tilted;
  FiveAxisCoordinates coordinates = FiveAxisCoordinates::ToolTip;
  FiveAxisDialect dialect = FiveAxisDialect::Generic;
  std::string tip_control_on;   ///< command that switches tip control on; empty for that of the dialect
  std::string tip_control_off;  ///< command that switches tip control off; empty for that of the dialect
  /// Line before `tip_control_off`; empty for that of the dialect.
  std::string before_tip_control_off;
  /// Distance by which the tip is lifted along the tool axis after the last path; less if a joint reaches its
  /// limit. In the generic dialect `program.end_code` does that instead.
  double retract_mm = 10.0;
  FiveAxisTurns turns = FiveAxisTurns::Counted;
  std::string letters;       ///< letters of rotary joints that programs name differently: "b=U,c=V"
  int program_number = 1;    ///< number of a Fanuc program, after the letter O
  std::string program_name;  ///< name of a Fanuc program, instead of its number; empty for none
  std::string extrusion;     ///< letter of the word that feeds material; empty for that of the dialect
  /// Greatest distance of the tip from its straight path while joints move from line to line.
  double chord_tolerance_mm = 0.05;
};

/// Adds the keys five_axis.*.
void describe(SettingsSchema& schema, FiveAxisSettings& settings);

/// The word that feeds material.
struct FeederWord {
  char letter = 'E';
  /// Whether the word is a position of an axis, counted from the start of the part; otherwise it is the
  /// amount of a motion.
  bool is_absolute = false;
};
/// The word that feeds material: in the generic dialect E, relative; in all others U, absolute, as these do
/// not know E. `five_axis.extrusion` replaces the letter; any letter but E is absolute.
/// @throws InvalidConfig if that letter is none of E, A, B, C, U, V, W, or is E in a dialect that does not
///   know it
FeederWord feederWord(const FiveAxisSettings& settings);

/// The line that switches tool-tip coordinates on; empty for none.
std::string tipControlOn(const FiveAxisSettings& settings);
/// The line that switches tool-tip coordinates off; empty for none.
std::string tipControlOff(const FiveAxisSettings& settings);
/// The line before the line that switches tool-tip coordinates off; empty for none. It moves the Z axis to
/// its reference position, because with parameter 5006#6 a Fanuc control may compensate the length of the
/// tool by a motion when it executes G49.
std::string beforeTipControlOff(const FiveAxisSettings& settings);

}  // namespace lamina
