// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/incline_job.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine_settings.hpp"

namespace lamina {

/// Which map a program is inclined by.
enum class InclineMap { Rotation, Shear, Scale, Matrix };

/// Mode of E until M82 or M83 sets it.
enum class InclineExtrusion { AsStated, Absolute, Relative };

/// How a program is inclined, as configuration, command line and ROS requests give it. Lists are empty
/// where nothing is given.
struct InclineSettings {
  MachineSettings machine{"none", ""};  ///< whose limits and axes hold
  InclineMap map = InclineMap::Rotation;
  double angle_deg = 45.0;
  std::string axis = "x";       ///< x, y, z or three numbers with commas between them
  std::vector<double> factors;  ///< of the scale in x, y, z
  std::string shear;            ///< "y,z,0.5" for y += 0.5 z
  std::vector<double> matrix;   ///< rows of three factors and a translation
  double belt_deg = 0.0;        ///< angle of a belt printer's gantry; 0 is none
  std::vector<double> table_position_mm;
  std::vector<double> offset_mm;
  std::vector<double> final_position_mm;
  std::vector<double> limits_mm;  ///< of the nozzle: lowest x, y, z, highest x, y, z
  double layer_height_mm = 0.0;   ///< 0 takes what the program states
  int decimals = -1;              ///< -1 is as the mode has it
  InclineExtrusion extrusion = InclineExtrusion::AsStated;
  RewriteSettings transform;  ///< all else
};

/// Adds the keys machine.name, machine.urdf and incline.*. The settings must outlive the schema.
void describe(SettingsSchema& schema, InclineSettings& settings);

/// The defaults, overridden by a YAML file and then by `overrides`, in order.
/// @param yaml_path  empty for none
/// @throws as `applySettings`
InclineSettings loadInclineSettings(const std::string& yaml_path, const std::vector<SettingText>& overrides);

/// The build space of the machine whose limits and axes hold; nothing if none is set.
/// @throws as `buildSpaceOf`
std::optional<BuildSpace> buildSpaceOf(const InclineSettings& settings);

/// The job that the settings give. Where neither machine nor limits are given, the corrected mode takes the
/// room of the large gantry. Programs for machines whose axes stand askew speak the values of these axes.
/// @param output  empty for that of `inclinedName`
/// @throws InvalidConfig if settings do not go together, or there is no such machine; FileError
/// @throws InvalidInput if the map cannot be undone
InclineJob inclineJob(const InclineSettings& settings, const std::string& program, const std::string& output);

}  // namespace lamina
