// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How layers are deposited on a given surface.
struct ConformalSettings {
  std::string base;  ///< path of the mesh that the layers of the part follow; empty to coat the part itself
  double max_tilt_deg = 60.0;  ///< greatest angle between `direction` and the normal of a covered face
  /// Direction that the covered faces face [part frame]; empty for upwards.
  std::vector<double> direction;
  double thickness_mm = 1.0;     ///< thickness of a coat
  double longest_edge_mm = 1.0;  ///< length above which edges of the covered surface are halved
  /// Greatest difference between the volumes of layers and part, for a part on a base; above it the part is
  /// refused.
  double largest_gap_percent = 5.0;
};

/// Adds the keys conformal.*.
void describe(SettingsSchema& schema, ConformalSettings& settings);

}  // namespace lamina
