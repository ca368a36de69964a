// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Settings by which material is deposited into voxels.
struct DepositionSettings {
  double voxel_mm = 0.1;   ///< side of a voxel
  double step = 0.51;      ///< spacing of the portions of material along a motion, in strand radii
  double reach_mm = 10.0;  ///< greatest distance from the middle of the strand at which material is deposited
  double bed_z_mm = 0.0;   ///< height of the bed, below which nothing is deposited
  /// Whether build aids are deposited too: skirt, brim, raft, supports, priming.
  bool are_build_aids_deposited = false;
  double memory_limit_mb = 0.0;  ///< greatest memory of the voxels; 0: the available memory of the computer
};

/// Adds the keys deposition.*.
void describe(SettingsSchema& schema, DepositionSettings& settings);

}  // namespace lamina
