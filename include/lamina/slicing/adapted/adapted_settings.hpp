// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How layers are adapted to walls that lean.
struct AdaptedSettings {
  double step_mm = 0.5;              ///< greatest distance between points of a curve
  int smoothing_window = 1;          ///< points of a curve that are averaged, odd; 1 is none
  double computing_height_mm = 0.0;  ///< layers that are computed, others lie between them; 0 computes all
  double max_lean_deg = 60.0;        ///< of walls from the vertical; a part whose walls lean more is refused
};

/// Adds the keys adapted.*.
void describe(SettingsSchema& schema, AdaptedSettings& settings);

}  // namespace lamina
