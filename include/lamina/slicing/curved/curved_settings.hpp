// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a part is cut into curved layers.
struct CurvedSettings {
  /// |n_z| of the unit normal up to which a face is upright: not lower, not upper.
  double normal_limit = 0.001;
  double longest_edge_mm = 1.0;  ///< length above which edges of the surfaces that are propagated are halved
  /// Greatest share of the part in no layer or in more than one before it is refused.
  double largest_gap_percent = 5.0;
  double largest_void_mm3 = 50.0;  ///< greatest `LayerCoverage::void_mm3` before the part is refused
};

/// Adds the keys curved.*.
void describe(SettingsSchema& schema, CurvedSettings& settings);

}  // namespace lamina
