// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What the words of a five-axis program mean.
enum class FiveAxisCoordinates : std::uint8_t {
  ToolTip,  ///< the tip over the bed, and the rotary joints; the controller moves the linear ones (RTCP)
  Joints,   ///< all joints, with inverse-time feed (G93)
};

/// Whose words for tool-tip coordinates are written.
enum class FiveAxisDialect : std::uint8_t { Generic, LinuxCnc, Fanuc, Siemens };

/// Which toolpaths are written as five-axis G-code.
enum class FiveAxisUse : std::uint8_t {
  Tilted,  ///< those that the linear axes alone cannot run
  Always,  ///< level ones too
};

/// How a toolpath is written as G-code for a machine that turns its nozzle or its table.
struct FiveAxisSettings {
  FiveAxisUse use = FiveAxisUse::Tilted;
  FiveAxisCoordinates coordinates = FiveAxisCoordinates::ToolTip;
  FiveAxisDialect dialect = FiveAxisDialect::Generic;
  std::string tip_control_on;   ///< empty for that of the dialect
  std::string tip_control_off;  ///< empty for that of the dialect
  std::string letters;          ///< of rotary joints that have another one in programs: "b=U,c=V"
  int program_number = 1;       ///< of a Fanuc program, behind its letter O
  std::string program_name;     ///< of a Fanuc program, in place of its number; empty for none
  std::string extrusion;        ///< letter of the word that feeds material; empty for that of the dialect
  double chord_tolerance_mm = 0.05;  ///< by which the tip may leave its line between two lines of joints
};

/// Adds the keys five_axis.*.
void describe(SettingsSchema& schema, FiveAxisSettings& settings);

/// The word that feeds material.
struct FeederWord {
  char letter = 'E';
  bool is_absolute = false;  ///< an axis of the controller, counted from the start of the part
};
/// E, relative, of the generic dialect; an absolute axis U of the others, which know no E, unless
/// `five_axis.extrusion` names another letter.
/// @throws InvalidConfig if that is none of E, A, B, C, U, V, W, or E where the dialect does not know it
FeederWord feederWord(const FiveAxisSettings& settings);

/// The line that turns tool-tip coordinates on; empty for none.
std::string tipControlOn(const FiveAxisSettings& settings);
/// The line that turns them off; empty for none.
std::string tipControlOff(const FiveAxisSettings& settings);

}  // namespace lamina
