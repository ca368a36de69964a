// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/program/drops/drop_dialect.hpp"
#include "lamina/program/five_axis/five_axis_settings.hpp"
#include "lamina/program/rapid/rapid_settings.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"

namespace lamina {

/// How a toolpath is written as a program.
struct ProgramSettings {
  std::string dialect = "marlin";  ///< name of the dialect of G-code for linear axes (`gcodeDialects`)
  double filament_diameter_mm = 1.75;
  /// Whether the diameter holds for programs that state another one, since somebody gave it for them; no
  /// setting.
  bool is_diameter_given = false;
  double flow = 1.0;                    ///< factor on all extrusion
  double nozzle_temperature_c = 210.0;  ///< 0 leaves the heater alone
  double bed_temperature_c = 60.0;      ///< 0 leaves the heater alone
  double retraction_length_mm = 0.8;    ///< length of filament that is retracted
  /// Speed of the filament during retraction and when it is extruded again.
  double retraction_feed_mm_s = 35.0;
  /// Written before the first motion. {nozzle_temperature_c} and {bed_temperature_c} are replaced;
  /// {lift_axis} is replaced by Z, or, if axes are askew, by the axis that lifts the nozzle.
  std::string start_code =
      "G28\nG0 {lift_axis}5 F600\n"
      "M140 S{bed_temperature_c}\nM104 S{nozzle_temperature_c}\n"
      "M190 S{bed_temperature_c}\nM109 S{nozzle_temperature_c}";
  std::string end_code = "G91\nG0 {lift_axis}5 F600\nG90\nM104 S0\nM140 S0\nM84";
  /// Greatest distance of arcs (G2, G3) from the waypoints that they replace; 0 for no arcs.
  double arcs_tolerance_mm = 0.0;
  /// Command that waits for the operator; "dialect" for the command of `dialect`. Its key in jobs is
  /// `pause.code`.
  std::string pause_code = "dialect";
  /// Offset of each tool's nozzle from that of tool 0 [mm], for which the program corrects positions; 0 for
  /// tools beyond the list.
  std::vector<Point3> tool_offsets_mm;
  std::string thumbnails;  ///< pictures in the program, as `thumbnailsFrom` reads them
  /// Whether time, filament and layer height are written as comments at the end.
  bool states_summary = false;
  bool states_settings = false;  ///< whether all settings of the job are written as comments at the end
  bool states_progress = false;  ///< whether the share done and the time left are reported at each percent
  bool states_accelerations = false;  ///< whether the accelerations of `motion.*` are set at the start
  DropDialect drops;
  FiveAxisSettings five_axis;  ///< for machines with rotary joints; has keys of its own
  RapidSettings rapid;         ///< for robots of ABB; has keys of its own
  RobotProgramSettings robot;  ///< for other robots; has keys of its own
  /// Name of the strategy that filled the part, for the header of drop programs; no setting.
  std::string strategy;
};

/// Adds the keys program.* and drop_program.*.
void describe(SettingsSchema& schema, ProgramSettings& settings);

/// Whether one of the settings that somebody typed is the diameter of the filament (`is_diameter_given`).
bool givesFilamentDiameter(const std::vector<SettingText>& typed);

/// The settings of RAPID, with the load of `robot_program.*` where they state none.
/// @throws InvalidConfig if a mass has no centre
RapidSettings rapidWithLoad(const ProgramSettings& program);

}  // namespace lamina
