// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Settings of the layer on the bed. Its greatest feed and its height are `feed.first_layer_mm_s` and
/// `slicing.first_layer_height_mm`.
struct FirstLayerSettings {
  double width_factor = 1.0;          ///< factor on the width of its beads
  double feed_factor = 1.0;           ///< factor on its feeds, except those of travels
  double flow = 1.0;                  ///< factor on the volume deposited
  double nozzle_temperature_c = 0.0;  ///< 0: the temperature of the program
  double bed_temperature_c = 0.0;     ///< 0: the temperature of the program
  double inset_mm = 0.0;  ///< distance by which its outlines are shrunk, as the bed squeezes its beads out
  int inset_layers = 1;   ///< number of layers over which the inset tapers to 0
};

/// Compensation of the changes in size that the process causes, before walls are planned.
struct CompensationSettings {
  double outline_mm = 0.0;     ///< inset of outer outlines; negative: outwards
  double holes_mm = 0.0;       ///< widening of holes on each side; negative: narrowing
  double least_hole_mm = 0.0;  ///< width above which holes stay as they are; 0 for no limit
  double shrink_xy = 0.0;      ///< share by which the print shrinks within the layers as it cools
  double shrink_z = 0.0;       ///< share by which it shrinks across the layers
};

/// Adds the keys first_layer.*.
void describe(SettingsSchema& schema, FirstLayerSettings& settings);
/// Adds the keys compensation.*.
void describe(SettingsSchema& schema, CompensationSettings& settings);

}  // namespace lamina
