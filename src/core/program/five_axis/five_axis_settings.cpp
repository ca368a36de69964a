// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/five_axis/five_axis_settings.hpp"

#include "lamina/base/error.hpp"

namespace lamina {

void describe(SettingsSchema& schema, FiveAxisSettings& settings) {
  schema.choice<FiveAxisUse>("five_axis.use", settings.use,
                             {{"tilted", FiveAxisUse::Tilted}, {"always", FiveAxisUse::Always}},
                             "Which toolpaths of a machine with rotary joints become five-axis G-code.");
  schema.choice<FiveAxisCoordinates>(
      "five_axis.coordinates", settings.coordinates,
      {{"tool_tip", FiveAxisCoordinates::ToolTip}, {"joints", FiveAxisCoordinates::Joints}},
      "Positions of the tip over the bed, or of the joints with inverse-time feed.");
  schema.choice<FiveAxisDialect>(
      "five_axis.dialect", settings.dialect,
      {{"generic", FiveAxisDialect::Generic},
       {"linuxcnc", FiveAxisDialect::LinuxCnc},
       {"fanuc", FiveAxisDialect::Fanuc},
       {"siemens", FiveAxisDialect::Siemens}},
      "Controller, for what turns tool-tip coordinates on and off, feeds material, waits and ends.");
  schema.text("five_axis.tip_control_on", settings.tip_control_on,
              "Line that turns tool-tip coordinates on; empty for that of the dialect.");
  schema.text("five_axis.tip_control_off", settings.tip_control_off,
              "Line that turns tool-tip coordinates off; empty for that of the dialect.");
  schema.text("five_axis.before_tip_control_off", settings.before_tip_control_off,
              "Line before the one that turns tool-tip coordinates off; empty for that of the dialect.");
  schema.number("five_axis.retract_mm", settings.retract_mm, {0.0, 1000.0},
                "Lift of the tip along the tool axis at the end of a program that is not in the generic "
                "dialect; less where a joint reaches its end.");
  schema.integer(
      "five_axis.program_number", settings.program_number, {1, 99999999},
      "Number of a program in the fanuc dialect, behind its letter O: four digits, eight beyond 9999.");
  schema.text("five_axis.program_name", settings.program_name,
              "Name of a program in the fanuc dialect in place of its number, for controls that take <NAME>; "
              "empty for "
              "none.");
  schema.choice<FiveAxisTurns>("five_axis.turns", settings.turns,
                               {{"counted", FiveAxisTurns::Counted}, {"modulo", FiveAxisTurns::Modulo}},
                               "Words of rotary joints that turn without end: whole turns counted, or the "
                               "angle within one turn, for axes "
                               "with rollover (fanuc: parameter 1008#0) and modulo axes (siemens: DC).");
  schema.text("five_axis.letters", settings.letters,
              "Letters of rotary joints that programs name otherwise: \"b=U,c=V\".");
  schema.text(
      "five_axis.extrusion", settings.extrusion,
      "Letter of the word that feeds material: E (relative) or an axis (absolute) of A, B, C, U, V, W; "
      "empty for E in the generic dialect and U in the others.");
  schema.number("five_axis.chord_tolerance_mm", settings.chord_tolerance_mm, Bounds::above(0.0, 10.0),
                "By how much the tip may leave its line while joints move from one line to the next.");
}

FeederWord feederWord(const FiveAxisSettings& settings) {
  const bool is_generic = settings.dialect == FiveAxisDialect::Generic;
  const std::string letter = settings.extrusion.empty() ? (is_generic ? "E" : "U") : settings.extrusion;
  const bool is_known = letter.size() == 1 && std::string("EABCUVW").find(letter) != std::string::npos;
  if (!is_known || (letter == "E" && !is_generic))
    throw InvalidConfig("five_axis.extrusion is '" + letter + "'; expected an axis of A, B, C, U, V, W" +
                        (is_generic ? ", or E" : ": the dialect knows no E"));
  return {letter[0], letter != "E"};
}

std::string tipControlOn(const FiveAxisSettings& settings) {
  if (!settings.tip_control_on.empty()) return settings.tip_control_on;
  if (settings.dialect == FiveAxisDialect::LinuxCnc) return "M428";
  if (settings.dialect == FiveAxisDialect::Fanuc) return "G43.4 H1";
  return settings.dialect == FiveAxisDialect::Siemens ? "TRAORI" : "";
}

std::string tipControlOff(const FiveAxisSettings& settings) {
  if (!settings.tip_control_off.empty()) return settings.tip_control_off;
  if (settings.dialect == FiveAxisDialect::LinuxCnc) return "M429";
  if (settings.dialect == FiveAxisDialect::Fanuc) return "G49";
  return settings.dialect == FiveAxisDialect::Siemens ? "TRAFOOF" : "";
}

std::string beforeTipControlOff(const FiveAxisSettings& settings) {
  if (!settings.before_tip_control_off.empty()) return settings.before_tip_control_off;
  return settings.dialect == FiveAxisDialect::Fanuc ? "G91 G28 Z0." : "";
}

}  // namespace lamina
