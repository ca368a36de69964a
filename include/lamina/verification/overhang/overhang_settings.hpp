// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Conditions under which a bead counts as supported (`findOverhangs`).
struct OverhangSettings {
  bool is_shown = false;  ///< whether the slicing node finds overhangs and shows them as markers
  double step_mm = 0.2;   ///< greatest distance between the samples of a bead
  double reach = 1.0;     ///< greatest distance from the middle of the bead to its support, in bead heights
  double overlap = 0.25;  ///< least share of the width of the bead that must be supported
};

/// Adds the keys overhang.*.
void describe(SettingsSchema& schema, OverhangSettings& settings);

}  // namespace lamina
