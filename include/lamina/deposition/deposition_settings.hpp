// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How material is deposited into voxels.
struct DepositionSettings {
  double voxel_mm = 0.1;            ///< side of a voxel
  double step = 0.51;               ///< of the nozzle from portion to portion, in radii of the strand
  double reach_mm = 10.0;           ///< farthest from the middle of the strand that material goes
  double bed_z_mm = 0.0;            ///< nothing is deposited below
  bool is_skirt_deposited = false;  ///< skirts count as deposited too
  double memory_limit_mb = 0.0;     ///< for the voxels; 0 for what is free on the machine
};

/// Adds the keys deposition.*.
void describe(SettingsSchema& schema, DepositionSettings& settings);

}  // namespace lamina
