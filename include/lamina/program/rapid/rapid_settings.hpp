// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Material and number of axes for which a program is written [Flores2018, section 6.1.3].
enum class RapidVariant : std::uint8_t { Powder3Axes, Powder5Axes, Wire3Axes };

/// "powder_3_axes", "powder_5_axes", "wire_3_axes".
const char* toString(RapidVariant variant);

/// Configuration of the arm in the targets: `fixed_configuration` in all targets, or in each target the
/// configuration of its joint values.
enum class RapidConfiguration : std::uint8_t { Fixed, Joints };

/// How a module starts and stops the process.
enum class RapidProcess : std::uint8_t {
  Outputs,  ///< by outputs, as in the listings
  Arc,      ///< ArcLStart, ArcL, ArcLEnd of the controller's arc package
};

/// How the modules are loaded if a program is divided into several.
enum class RapidLoading : std::uint8_t {
  Together,  ///< all of them are loaded beforehand
  InTurn,    ///< main loads each from the controller's home folder, runs it and unloads it
};

/// Which logical axis of the controller an external joint is, and how it counts: value = sign · joint + zero.
struct RapidExternal {
  std::string joint;     ///< external_1, ...
  std::size_t slot = 0;  ///< 0 for eax_a, to 5 for eax_f
  double sign = 1.0;
  double zero = 0.0;  ///< [mm, deg]
};

/// How a toolpath is written as RAPID, the language of ABB's robots. Names are those of the listings in
/// [Flores2018, figures 66 to 71]; lengths [mm], orientations w x y z.
struct RapidSettings {
  RapidVariant variant = RapidVariant::Powder5Axes;
  std::string module;                    ///< name of the module; empty for that of the file, or Lamina
  std::string procedure = "deposit";     ///< prefix of the names of procedures that deposit
  std::string tool;                      ///< name; empty for that of the variant's listing
  std::string work_object;               ///< name; empty for that of the variant's listing
  std::string start_point = "Pinicial";  ///< origin of the offsets in 3-axis variants
  std::string offset = "off_";           ///< prefix of the names of the three offsets
  std::string deposition_speed = "speed_prueba";
  std::string air_speed = "speed_aire";
  std::string zone = "z0";          ///< name of the zone at points where the process neither starts nor ends
  std::string end_zone = "fine";    ///< name of the zone at points where the process starts or ends
  double zone_mm = 0.3;             ///< radius of `zone` if that is not the name of a predefined zone
  double turn_speed_deg_s = 500.0;  ///< speed at which the tool rotates, in each declared speed

  /// Analogue outputs of process values: see `rapidLevels`.
  std::string levels;
  bool has_dry_flag = false;  ///< whether the module declares lamina_dry, with which it runs without process
  /// Speed of a dry run by that flag, in percent of the program's speeds.
  double dry_speed_percent = 100.0;
  bool declares_cell = true;  ///< whether the module declares tool, work object and start point
  /// Pose of the tip in the flange's frame: x y z [mm], w x y z. If it is empty, the pose of the arm's
  /// description, or, without an arm, the flange itself.
  std::vector<double> tool_frame;
  std::vector<double> tool_centre_of_gravity_mm = {0, 0, 1};  ///< centre in the flange's frame
  /// Mass of the tool. If 0, mass and centre come from `robot_program.*` or from the cell file; if neither
  /// states a mass, 1 kg at (0, 0, 1) mm.
  double tool_mass_kg = 0.0;
  bool is_load_given = true;  ///< no setting: whether somebody states the load (`checkedRapidSettings`)
  /// No setting: whether targets state `external_axis` where no joint gives a value; eax_a is 9e+09
  /// otherwise.
  bool has_external_axis = true;
  /// Mechanical unit that carries the bed. If it is empty, the bed is fixed, unless an external axis of the
  /// arm's description carries it: then the unit is STN1.
  std::string positioner;
  /// Pose of the bed in the world, or in the user frame of its positioner: x y z [mm], w x y z. If it is
  /// empty, the pose of the arm's description, or, without an arm, the identity.
  std::vector<double> work_object_frame;
  /// Distance from the part, back along the tool axis, at which an arm's program starts and ends.
  double approach_mm = 50.0;
  /// Position of `start_point` in the work object as declared; it holds until the point is taught anew.
  std::vector<double> start_point_mm = {0, 0, 0};

  RapidConfiguration configuration = RapidConfiguration::Fixed;
  std::vector<double> fixed_configuration = {-1, 0, 0, 2};  ///< cf1, cf4, cf6, cfx
  /// Value of the first external axis [mm, deg] where joint values do not state it.
  double external_axis = 0.0;
  /// Logical axes of the controller, by external joint: see `rapidExternals`. Empty: eax_a, eax_b, ... in the
  /// order of the joints.
  std::string external_axes;
  /// No setting: those of an arm, in the order of its external joints.
  std::vector<RapidExternal> external_map;
  /// Targets have five external axes as printed in [Flores2018]; RAPID has six.
  bool is_thesis_compatible = false;

  std::string laser_on = "Haz_ON";  ///< procedures of the powder variants
  std::string laser_off = "Haz_OFF";
  std::string laser_signal = "SolicitudLaser";
  std::string laser_ready_signal = "LaserON";
  std::string wire_signal = "SolicitudDevHilo";
  std::string powder_signal = "SolicitudPolvo";
  std::string gas_signal = "SolicitudGas";
  std::string wire_trigger = "TimeHilo_OFF";
  /// Signals that have other names on the controller: "name=name of the controller, ...".
  std::string aliases;

  RapidProcess process = RapidProcess::Outputs;
  std::string seam_data = "seam1";  ///< name of the seam data of arc moves, on the controller
  std::string weld_data = "weld1";  ///< name of the weld data of arc moves
  std::string weave_data;           ///< name of the weave data of arc moves; empty for none

  double powder_wait_s = 0.0;     ///< wait from powder and gas on to the first move
  double laser_off_wait_s = 1.2;  ///< wait after laser off, in the powder variants
  double wire_lead_s = 0.5;       ///< waiting1: wait from wire on to laser on
  double laser_lead_s = 0.5;      ///< waiting2: wait from laser on to the move
  double layer_wait_s = 1.0;      ///< t_capas: wait after laser off, in the wire variant
  double wire_stop_s = 0.2;       ///< time before the end of a run at which the wire stops

  int max_points = 0;  ///< greatest number of points in a module; 0 for all in one
  RapidLoading loading = RapidLoading::Together;
};

/// Adds the keys rapid.*.
void describe(SettingsSchema& schema, RapidSettings& settings);

/// The settings with empty names filled in from the variant's listing.
/// @throws InvalidConfig if a name is no identifier of RAPID (a letter, then letters, digits and underscores,
///   at most 32 characters), is a reserved word, or is used for two things; if a list has the wrong length;
///   if an orientation is not of length 1; if an alias names no signal; if arc moves are asked for with the
///   wire variant
RapidSettings checkedRapidSettings(RapidSettings settings);

/// A signal and its name on the controller.
struct RapidAlias {
  std::string signal;
  std::string on_controller;
};
/// The aliases in a list "name=name of the controller, ...", in its order.
/// @throws InvalidConfig if an entry has no "="
std::vector<RapidAlias> rapidAliases(const std::string& text);

/// An analogue output that follows a process value.
struct RapidLevel {
  std::string name;    ///< name of the process value
  std::string signal;  ///< name of the output
  double per = 1.0;    ///< value of the output for each unit of the process value
};

/// The levels of `rapid.levels`, as "laser_power_w=aoLaser*0.0025, wire_speed_mm_s=aoWire*0.04".
/// @throws InvalidConfig if an entry is not of that form, or occurs twice
std::vector<RapidLevel> rapidLevels(const std::string& text);

/// The axes of `rapid.external_axes`, as "external_1=eax_b, external_2=-eax_c+90".
/// @throws InvalidConfig if one is no joint=axis, with a minus before and a zero behind where there are any,
/// or
///   stands twice
std::vector<RapidExternal> rapidExternals(const std::string& text);

}  // namespace lamina
