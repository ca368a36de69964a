// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How the lines inside the perimeter are laid out.
enum class HybridLines {
  Fitted,  ///< lines of variable width that divide the area inside the perimeter evenly
  Metal,   ///< lines on a fixed grid, adapted to the perimeter as in [Flores2018, section 6.1.2]
};

/// How the ends of lines on the grid are brought to the right distance from the perimeter.
enum class LongitudinalAdaptation {
  TwoPass,  ///< each end is moved along its line towards the nearest perimeter point, twice
  Clipped,  ///< each line is clipped by the perimeter offset inwards
};

/// Settings of the hybrid strategy. Distances are in line spacings.
struct HybridSettings {
  HybridLines lines = HybridLines::Fitted;
  LongitudinalAdaptation longitudinal = LongitudinalAdaptation::Clipped;
  double grid_x_mm = 0.0;  ///< x of a node of the grid
  double grid_y_mm = 0.0;  ///< y of that node
  /// Distance of the perimeter points towards which `TwoPass` moves ends of lines.
  double perimeter_step = 0.25;
  /// Distance of the outermost line from the perimeter above which a curve is added.
  double add_above = 1.5;
  double delete_below = 1.2;      ///< distance below which the curve replaces the outermost line
  double approach = 1.0;          ///< distance of the curve, and of ends of lines, from the perimeter
  int curve_points = 20;          ///< number of points of the curve
  double end_margin = 0.5;        ///< distance between the end of the curve and the line beside it
  int extra_perimeter_every = 0;  ///< every n-th layer has one more perimeter; 0 for none
};

/// Adds the keys hybrid.*.
void describe(SettingsSchema& schema, HybridSettings& settings);

}  // namespace lamina
