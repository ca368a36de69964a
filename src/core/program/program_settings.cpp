// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/program_settings.hpp"

#include <algorithm>

#include "lamina/program/gcode/gcode_dialect.hpp"

namespace lamina {
namespace {

constexpr const char* kFilamentDiameter = "program.filament_diameter_mm";

}  // namespace

void describe(SettingsSchema& schema, ProgramSettings& settings) {
  schema.choice("program.dialect", settings.dialect, gcodeDialects().names(),
                "Dialect of G-code for machines with linear axes.");
  schema.renamed("program.flavour", "program.dialect");
  schema.number(kFilamentDiameter, settings.filament_diameter_mm, Bounds::above(0.0, 20.0),
                "Diameter of the filament.");
  schema.number("program.flow", settings.flow, Bounds::above(0.0, 10.0), "Factor on all extrusion.");
  schema.number("program.nozzle_temperature_c", settings.nozzle_temperature_c, {0.0, 500.0},
                "Nozzle temperature while printing; 0 leaves the heater alone.");
  schema.number("program.bed_temperature_c", settings.bed_temperature_c, {0.0, 200.0},
                "Bed temperature while printing; 0 leaves the heater alone.");
  schema.number("program.retraction_length_mm", settings.retraction_length_mm, {0.0, 50.0},
                "Filament pulled back on retracted paths.");
  schema.number("program.retraction_feed_mm_s", settings.retraction_feed_mm_s, Bounds::above(0.0, 500.0),
                "Speed of the filament while it is pulled back and pushed forth.");
  schema.text(
      "program.start_code", settings.start_code,
      "G-code before the first motion; {nozzle_temperature_c}, {bed_temperature_c} and {lift_axis} are "
      "replaced.");
  schema.text("program.end_code", settings.end_code, "G-code after the last motion.");
  schema.number(
      "program.arcs_tolerance_mm", settings.arcs_tolerance_mm, {0.0, 1.0},
      "By how much arcs (G2, G3) may leave the waypoints and chords that they stand for; 0 for none.");
  schema.text("program.thumbnails", settings.thumbnails,
              "Pictures of the part in G-code, with commas between them: \"220x124 png, 16x16 qoi\"; formats "
              "are png, qoi, jpg.");
  schema.flag("program.closing_comments", settings.states_summary,
              "Whether G-code ends with its time, its filament and the layer height as comments.");
  schema.flag("program.settings_in_file", settings.states_settings,
              "Whether G-code ends with all settings as comments, by which the slice can be repeated.");
  schema.flag("program.progress", settings.states_progress,
              "Whether G-code reports to the machine how much is done and how long the rest takes (M73).");
  schema.flag("program.accelerations", settings.states_accelerations,
              "Whether G-code sets the accelerations of motion.* at its start.");
  describe(schema, settings.drops);
}

bool givesFilamentDiameter(const std::vector<SettingText>& typed) {
  return std::any_of(typed.begin(), typed.end(),
                     [](const SettingText& setting) { return setting.key == kFilamentDiameter; });
}

RapidSettings rapidWithLoad(const ProgramSettings& program) {
  RapidSettings rapid = program.rapid;
  if (rapid.tool_mass_kg > 0.0 || program.robot.tool_mass_kg == 0.0) return rapid;
  requireConsistent(program.robot);
  rapid.tool_mass_kg = program.robot.tool_mass_kg;
  rapid.tool_centre_of_gravity_mm = program.robot.tool_centre_of_gravity_mm;
  return rapid;
}

}  // namespace lamina
