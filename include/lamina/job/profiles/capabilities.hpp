// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

struct JobSettings;

/// What a machine can do besides move. A 0 is not known, and refuses nothing.
struct MachineCapabilities {
  double nozzle_mm = 0.0;  ///< diameter of the orifice
  double greatest_nozzle_c = 0.0;
  double greatest_bed_c = 0.0;
  double least_layer_mm = 0.0;
  double greatest_layer_mm = 0.0;
  bool has_bed_heater = true;
  bool has_fan = true;
};

/// What is deposited.
struct MaterialSettings {
  std::string name;            ///< in messages and programs; empty if nobody has said
  double density_g_cm3 = 0.0;  ///< 0 if not known
};

/// Adds machine.nozzle_mm and the others.
void describe(SettingsSchema& schema, MachineCapabilities& capabilities);
/// Adds the keys material.*.
void describe(SettingsSchema& schema, MaterialSettings& material);

/// Checks temperatures, fan and layer heights against the machine.
/// @throws InvalidConfig naming the key, its value, and what the machine can do
void requireCapable(const JobSettings& settings);

}  // namespace lamina
