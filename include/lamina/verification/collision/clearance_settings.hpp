// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings.hpp"

namespace lamina {

/// How closely a machine's head is checked for collisions.
struct ClearanceSettings {
  bool is_shown = false;       ///< by the slicing node, which then checks, as markers
  double spacing_mm = 1.0;     ///< between the places of the nozzle that are looked at, at most
  double tolerance_mm = 0.05;  ///< how deep the head may be in bed or material
};

/// Adds the keys clearance.*.
void describe(SettingsSchema& schema, ClearanceSettings& settings);

}  // namespace lamina
