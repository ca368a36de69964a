// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Machine code to insert, by its place in a program. Placeholders in braces are replaced (`addHooks`).
struct HookSettings {
  std::string part_start;
  std::string part_end;
  std::string layer_start;
  std::string layer_end;
  std::string tool_change;    ///< after the change
  std::string pause;          ///< before the machine waits
  SettingTable before_role;   ///< by the role's name
  SettingTable after_role;    ///< by the role's name
  SettingTable at_layer;      ///< by the layer's number, from 0
  SettingTable at_height_mm;  ///< by the height reached [mm]
  /// Whether code may move axes; if so, position, modes and feed are restated after the code.
  bool moves_axes = false;
};

/// Places at which the machine waits for its operator.
struct PauseSettings {
  std::vector<double> at_layers;  ///< numbers of layers, from 0, before which the machine waits
  /// Heights over the bed [mm]: for each, the machine waits before every part's first layer that begins at or
  /// above it.
  std::vector<double> at_heights_mm;
};

/// Adds the keys hooks.*.
void describe(SettingsSchema& schema, HookSettings& settings);
/// Adds the keys pause.at_layers and pause.at_heights_mm.
void describe(SettingsSchema& schema, PauseSettings& settings);

/// @throws InvalidConfig if code holds an unknown placeholder, a carriage return, more than 1000 lines, or a
///   command that moves axes or changes modes without `moves_axes`; if a role, a layer or a height is not
///   valid
void requireConsistent(const HookSettings& settings);
void requireConsistent(const PauseSettings& settings);

}  // namespace lamina
