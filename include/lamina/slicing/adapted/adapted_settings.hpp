// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How layers follow leaning walls (`adaptedLayers`).
struct AdaptedSettings {
  double step_mm = 0.5;      ///< greatest distance between points of a curve
  int smoothing_window = 1;  ///< number of points over which curves are averaged, odd; 1 for no smoothing
  /// Distance of the computed layers, a multiple of the layer height; layers between them are interpolated. 0
  /// computes all.
  double computing_height_mm = 0.0;
  /// Greatest angle of walls from the vertical; parts with walls that lean more are refused.
  double max_lean_deg = 60.0;
};

/// Adds the keys adapted.*.
void describe(SettingsSchema& schema, AdaptedSettings& settings);

}  // namespace lamina
