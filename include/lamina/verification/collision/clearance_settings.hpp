// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Which programs are refused if the machine would collide when it runs them (`checkRun`).
enum class ClearanceNeed {
  Turning,  ///< programs for machines with rotary joints, and those with layers that are not plane
  Always,   ///< all programs
  Never,    ///< no program
};

/// Whether and how a machine is checked for collisions.
struct ClearanceSettings {
  ClearanceNeed need = ClearanceNeed::Turning;
  /// Whether the lean of the tool axis is reduced where the machine would otherwise collide.
  bool raises_tool_axis = false;
  bool is_shown = false;       ///< whether the slicing node checks for collisions and shows them as markers
  double spacing_mm = 1.0;     ///< greatest distance between positions of the nozzle that are checked
  double tolerance_mm = 0.05;  ///< depth to which bodies may be in bed or material
};

/// Adds the keys clearance.*.
void describe(SettingsSchema& schema, ClearanceSettings& settings);

}  // namespace lamina
