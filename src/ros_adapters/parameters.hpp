// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// The parameters below a node handle's namespace as settings with dotted keys: slicing/layer_height_mm
/// becomes slicing.layer_height_mm. Lists are read as in files of settings: values separated by commas,
/// groups under their numbers. None if nothing is set.
/// @throws InvalidConfig if a parameter is a date or binary, or a list of values and groups
std::vector<SettingText> settingsFromParameters(const ros::NodeHandle& node);

/// Sets all parameters below a node handle's namespace.
/// @throws InvalidConfig if a key is unknown, or a value is of another type than the setting or out of bounds
void applyParameters(SettingsSchema& schema, const ros::NodeHandle& node);

/// One line per setting, "key: value", as a node prints them at its start.
std::string describeSettings(const SettingsSchema& schema);

}  // namespace lamina
