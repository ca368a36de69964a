// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How the runs of a fill are made smooth, and with how many points.
struct SmoothingSettings {
  double window_mm = 0.0;     ///< along the run round a corner, which a curve replaces; 0 for none
  double step_mm = 0.05;      ///< between points on these curves
  double tolerance_mm = 0.0;  ///< how far points left out lie from the run; 0 leaves none out
};

/// Adds the keys smoothing.*.
void describe(SettingsSchema& schema, SmoothingSettings& settings);

}  // namespace lamina
