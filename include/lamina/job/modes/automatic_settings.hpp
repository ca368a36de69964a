// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How `slicing.mode: auto` chooses. Shares are of the part's surface.
struct AutomaticSettings {
  double good_unsupported_percent = 1.0;  ///< that a mode may leave and still be good enough
  double alike_percent = 0.5;             ///< by which shares differ at most to count as alike
  double longest_time = 3.0;              ///< of printing, over that of the quickest mode that takes the part
  double max_overhang_deg = 45.0;         ///< that the material takes, whatever the mode
  bool follows_skins = false;             ///< whether layers that follow gentle slopes come first
};

/// Adds the keys auto.*.
void describe(SettingsSchema& schema, AutomaticSettings& settings);

}  // namespace lamina
