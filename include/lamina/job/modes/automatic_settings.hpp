// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Settings by which `slicing.mode: auto` chooses a mode. Percentages are shares of the part's surface.
struct AutomaticSettings {
  double good_unsupported_percent = 1.0;  ///< unsupported share up to which a mode is good enough
  double alike_percent = 0.5;  ///< unsupported shares that differ by no more than this count as equal
  /// Longest printing time of a mode, as a multiple of the shortest of the modes that can slice the part.
  double longest_time = 3.0;
  double max_overhang_deg = 45.0;  ///< greatest overhang that the material allows, in every mode
  bool follows_skins = false;      ///< whether modes whose layers follow gentle slopes are tried first
};

/// Adds the keys auto.*.
void describe(SettingsSchema& schema, AutomaticSettings& settings);

}  // namespace lamina
