// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// When a bead counts as carried.
struct OverhangSettings {
  bool is_shown = false;  ///< by the slicing node, which then looks, as markers
  double step_mm = 0.2;   ///< between the places of a bead that are looked at, at most
  double reach = 1.0;     ///< how far from its middle something must be met, in bead heights
  double overlap = 0.25;  ///< least part of its width that must lie on something
};

/// Adds the keys overhang.*.
void describe(SettingsSchema& schema, OverhangSettings& settings);

}  // namespace lamina
