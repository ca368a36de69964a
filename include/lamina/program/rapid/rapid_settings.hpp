// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What is deposited by how many axes [Flores2018, section 6.1.3].
enum class RapidVariant : std::uint8_t { Powder3Axes, Powder5Axes, Wire3Axes };

/// "powder_3_axes", "powder_5_axes", "wire_3_axes".
const char* toString(RapidVariant variant);

/// Where the configuration of the arm in a target comes from.
enum class RapidConfiguration : std::uint8_t { Fixed, Joints };

/// By what a module starts and stops the process.
enum class RapidProcess : std::uint8_t {
  Outputs,  ///< as in the listings
  Arc,      ///< ArcLStart, ArcL, ArcLEnd of the controller's arc package
};

/// How the modules of a program that is split come to the controller.
enum class RapidLoading : std::uint8_t {
  Together,  ///< all of them are loaded beforehand
  InTurn,    ///< main loads each from the controller's home folder, runs it and unloads it
};

/// How a toolpath is written as RAPID, the language of ABB's robots. Names are those of the listings in
/// [Flores2018, figures 66 to 71]; lengths [mm], orientations w x y z.
struct RapidSettings {
  RapidVariant variant = RapidVariant::Powder5Axes;
  std::string module;                    ///< empty for that of the file, or Lamina
  std::string procedure = "deposit";     ///< begins the names of the procedures that deposit
  std::string tool;                      ///< empty for that of the variant's listing
  std::string work_object;               ///< empty for that of the variant's listing
  std::string start_point = "Pinicial";  ///< origin of the offsets in 3-axis variants
  std::string offset = "off_";           ///< begins the names of the three offsets
  std::string deposition_speed = "speed_prueba";
  std::string air_speed = "speed_aire";
  std::string zone = "z0";          ///< of points between
  std::string end_zone = "fine";    ///< of points where the process starts or ends
  double zone_mm = 0.3;             ///< radius of `zone` where its name is none of RAPID's own
  double turn_speed_deg_s = 500.0;  ///< of the tool, in each speed

  bool declares_cell = true;  ///< whether the module holds tool, work object and start point
  /// Tip over the flange; empty for that of the arm's description, or the flange itself without an arm.
  std::vector<double> tool_frame;
  std::vector<double> tool_centre_of_gravity_mm = {0, 0, 1};
  double tool_mass_kg = 1.0;
  /// Mechanical unit that carries the bed; empty if it stands still, or for STN1 where an external axis of
  /// the arm's description carries it.
  std::string positioner;
  /// The bed over the world, or over the user frame of its positioner; empty for that of the arm's
  /// description, or the world without an arm.
  std::vector<double> work_object_frame;
  double approach_mm = 50.0;  ///< back along the tool axis, where an arm's program starts and ends
  std::vector<double> start_point_mm = {0, 0, 0};  ///< in the work object, as long as nobody taught another

  RapidConfiguration configuration = RapidConfiguration::Fixed;
  std::vector<double> fixed_configuration = {-1, 0, 0, 2};  ///< cf1, cf4, cf6, cfx
  double external_axis = 0.0;  ///< value of the first external axis [mm, deg] where no joint reports it
  bool is_thesis_compatible = false;  ///< five external axes, as printed in [Flores2018]; RAPID has six

  std::string laser_on = "Haz_ON";  ///< procedures of the powder variants
  std::string laser_off = "Haz_OFF";
  std::string laser_signal = "SolicitudLaser";
  std::string laser_ready_signal = "LaserON";
  std::string wire_signal = "SolicitudDevHilo";
  std::string powder_signal = "SolicitudPolvo";
  std::string gas_signal = "SolicitudGas";
  std::string wire_trigger = "TimeHilo_OFF";
  std::string aliases;  ///< "name=name of the controller, ..."

  RapidProcess process = RapidProcess::Outputs;
  std::string seam_data = "seam1";  ///< names of data that the controller holds, of arc statements
  std::string weld_data = "weld1";
  std::string weave_data;  ///< empty for none

  double powder_wait_s = 0.0;     ///< from powder and gas on to the first move
  double laser_off_wait_s = 1.2;  ///< of the powder variants
  double wire_lead_s = 0.5;       ///< waiting1, from wire on to laser on
  double laser_lead_s = 0.5;      ///< waiting2, from laser on to the move
  double layer_wait_s = 1.0;      ///< t_capas, after laser off
  double wire_stop_s = 0.2;       ///< how long before the end of a run the wire stops

  int max_points = 0;  ///< in a module; 0 for all in one
  RapidLoading loading = RapidLoading::Together;
};

/// Adds the keys rapid.*.
void describe(SettingsSchema& schema, RapidSettings& settings);

/// The settings with empty names filled in from the variant's listing.
/// @throws InvalidConfig if a name is no identifier of RAPID (a letter, then letters, digits and underscores,
///   32 at most), a reserved word, or stands for two things; if a list is not of its length; if an alias
///   names no signal
RapidSettings checkedRapidSettings(RapidSettings settings);

/// A signal and its name on the controller.
struct RapidAlias {
  std::string signal;
  std::string on_controller;
};
/// In the order in which they stand.
/// @throws InvalidConfig if it is no list of name=name
std::vector<RapidAlias> rapidAliases(const std::string& text);

}  // namespace lamina
