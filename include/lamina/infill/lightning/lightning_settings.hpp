// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Settings of the lightning infill, whose branches support skins.
struct LightningSettings {
  /// Greatest angle of a branch from the vertical; larger angles take less material.
  double angle_deg = 45.0;
};

/// Adds the keys lightning.*.
void describe(SettingsSchema& schema, LightningSettings& settings);

}  // namespace lamina
