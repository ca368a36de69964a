// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

struct JobSettings;

/// Capabilities of a machine besides its motion. A number that is 0 is not known and is not checked.
struct MachineCapabilities {
  double nozzle_mm = 0.0;  ///< diameter of the orifice
  double greatest_nozzle_c = 0.0;
  double greatest_bed_c = 0.0;
  double least_layer_mm = 0.0;
  double greatest_layer_mm = 0.0;
  bool has_bed_heater = true;
  bool has_fan = true;
};

/// The material that is deposited.
struct MaterialSettings {
  std::string name;            ///< name in messages and programs; empty if not stated
  double density_g_cm3 = 0.0;  ///< 0 if not known
};

/// Adds the keys machine.nozzle_mm, machine.greatest_nozzle_c, machine.greatest_bed_c,
/// machine.least_layer_mm, machine.greatest_layer_mm, machine.has_bed_heater and machine.has_fan.
void describe(SettingsSchema& schema, MachineCapabilities& capabilities);
/// Adds the keys material.*.
void describe(SettingsSchema& schema, MaterialSettings& material);

/// Checks temperatures, fan and layer heights against the machine and the nozzles of its tools.
/// @throws InvalidConfig naming the key, its value, and what the machine can do
void requireCapable(const JobSettings& settings);

/// Checks the heights of layers that a table states, from the first on, as `requireCapable` checks the
/// heights of adaptive layers.
/// @throws InvalidConfig naming the layer, its height, and what the machine can do
void requireCapableOfTable(const std::vector<double>& heights_mm, const JobSettings& settings);

}  // namespace lamina
