// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/incline_job.hpp"
#include "lamina/kinematics/machine_choice.hpp"

namespace lamina {

/// Kind of the map by which a program is inclined.
enum class InclineMap { Rotation, Shear, Scale, Matrix };

/// Mode of the E words before the first M82 or M83.
enum class InclineExtrusion { AsStated, Absolute, Relative };

/// Settings by which a program is inclined, as configuration, command line and ROS requests state them. An
/// empty list means that the setting is not given.
struct InclineSettings {
  /// Machine whose limits and axes are used; "none" without a URDF for no machine.
  MachineSettings machine{"none", ""};
  InclineMap map = InclineMap::Rotation;
  double angle_deg = 45.0;      ///< angle of the rotation, right-handed
  std::string axis = "x";       ///< axis of the rotation: x, y, z or three numbers with commas between them
  std::vector<double> factors;  ///< factors of the scale along x, y, z
  std::string shear;            ///< the shear, as "y,z,0.5" for y += 0.5 z
  std::vector<double> matrix;   ///< affine map by its three rows: three factors and a translation [mm] each
  double belt_deg = 0.0;  ///< angle at which a belt printer's gantry leans, 15 to 90; 0 for no such printer
  std::vector<double> table_position_mm;  ///< x and y to which the middle of the part is moved
  std::vector<double> offset_mm;  ///< x, y and z by which the part is moved after it was put on the bed
  std::vector<double> final_position_mm;  ///< x, y and z to which the nozzle moves at the end
  std::vector<double> limits_mm;          ///< limits of the nozzle: lowest x, y, z, then highest x, y, z
  double layer_height_mm = 0.0;  ///< height of the lowest deposition; 0 for the height stated by the program
  int decimals = -1;             ///< number of decimals of coordinates; -1 for that of the mode
  InclineExtrusion extrusion = InclineExtrusion::AsStated;
  RewriteSettings transform;  ///< all further settings
};

/// Adds the keys machine.name, machine.urdf and incline.*. The settings must outlive the schema.
void describe(SettingsSchema& schema, InclineSettings& settings);

/// The defaults, overridden by a YAML file and then by `overrides`, in order.
/// @param yaml_path  empty for none
/// @throws as `applySettings`
InclineSettings loadInclineSettings(const std::string& yaml_path, const std::vector<SettingText>& overrides);

/// The build space of `settings.machine`; nothing if no machine is set.
/// @throws as `buildSpaceOf`
std::optional<BuildSpace> buildSpaceOf(const InclineSettings& settings);

/// The job that the settings describe. In the corrected mode the volume of the large gantry is the limit if
/// neither a machine nor limits are given. For a machine whose axes are not at right angles, the program
/// states values of these axes.
/// @param output  empty for that of `inclinedName`
/// @throws InvalidConfig if settings contradict each other, or there is no such machine
/// @throws FileError if the machine's description cannot be read
/// @throws InvalidInput if the map has no inverse
InclineJob inclineJob(const InclineSettings& settings, const std::string& program, const std::string& output);

}  // namespace lamina
