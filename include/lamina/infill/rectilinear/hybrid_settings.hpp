// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Where the lines inside the perimeter run.
enum class HybridLines {
  Fitted,  ///< variable-width lines that divide what the perimeter leaves evenly, filled to their ends
  Metal,   ///< rows of grid nodes, adapted to the perimeter as in [Flores2018, section 6.1.2]
};

/// How lines on the grid are brought to the right distance from the perimeter at their ends.
enum class LongitudinalAdaptation {
  TwoPass,  ///< each end is moved along its line towards the nearest perimeter point, twice
  Clipped,  ///< each line is cut by the perimeter offset inwards
};

/// What the hybrid strategy asks for. Distances are in line spacings.
struct HybridSettings {
  HybridLines lines = HybridLines::Fitted;
  LongitudinalAdaptation longitudinal = LongitudinalAdaptation::Clipped;
  double grid_x_mm = 0.0;  ///< a node of the grid
  double grid_y_mm = 0.0;
  double perimeter_step = 0.25;  ///< of the perimeter points that ends of lines on the grid are moved towards
  double add_above = 1.5;        ///< a curve is added where the outermost line is farther from the perimeter
  double delete_below = 1.2;     ///< that line is replaced by the curve where it is nearer
  double approach = 1.0;         ///< from the curve to the perimeter
  int curve_points = 20;
  double end_margin = 0.5;        ///< by which the curve ends short of the line beside it
  int extra_perimeter_every = 0;  ///< layers with one perimeter more; 0 for none
};

/// Adds the keys hybrid.*.
void describe(SettingsSchema& schema, HybridSettings& settings);

}  // namespace lamina
