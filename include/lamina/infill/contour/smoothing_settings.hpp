// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How the corners of infill runs are smoothed, and how their points are thinned out.
struct SmoothingSettings {
  double window_mm = 0.0;  ///< length of the run around each corner that a curve replaces; 0 keeps corners
  double step_mm = 0.05;   ///< distance of points on these curves
  /// Greatest distance between the run and a point that is left out; 0 keeps all points.
  double tolerance_mm = 0.0;
};

/// Adds the keys smoothing.*.
void describe(SettingsSchema& schema, SmoothingSettings& settings);

}  // namespace lamina
