// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Of the branches that hold up skins.
struct LightningSettings {
  double angle_deg = 45.0;  ///< from the vertical, by which a branch may lean from layer to layer
};

/// Adds the keys lightning.*.
void describe(SettingsSchema& schema, LightningSettings& settings);

}  // namespace lamina
