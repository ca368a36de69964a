// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Which programs are not written unless the machine runs them clear of everything (`checkRun`).
enum class ClearanceNeed {
  Turning,  ///< those of joints that turn, and those of layers that are not plane
  Always,
  Never,
};

/// How closely a machine's head is checked for collisions.
struct ClearanceSettings {
  ClearanceNeed need = ClearanceNeed::Turning;
  bool raises_tool_axis = false;  ///< where the machine would run into something, before a program is refused
  bool is_shown = false;          ///< by the slicing node, which then checks, as markers
  double spacing_mm = 1.0;        ///< between the places of the nozzle that are looked at, at most
  double tolerance_mm = 0.05;     ///< how deep the head may be in bed or material
};

/// Adds the keys clearance.*.
void describe(SettingsSchema& schema, ClearanceSettings& settings);

}  // namespace lamina
