// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings.hpp"

namespace lamina {

/// What is different in the layer on the bed. Its greatest feed and height are settings of their own,
/// `feed.first_layer_mm_s` and `slicing.first_layer_height_mm`.
struct FirstLayerSettings {
  double width_factor = 1.0;          ///< on the width of its beads
  double feed_factor = 1.0;           ///< on all its feeds, travels excepted
  double flow = 1.0;                  ///< factor on what is deposited
  double nozzle_temperature_c = 0.0;  ///< 0 for that of the program
  double bed_temperature_c = 0.0;     ///< the same
  double inset_mm = 0.0;              ///< by which outlines are shrunk that are squeezed out on the bed
  int inset_layers = 1;               ///< over which the inset tapers to 0
};

/// What the process does to the size of a part, made up for before walls are laid.
struct CompensationSettings {
  double outline_mm = 0.0;     ///< taken off outer outlines; negative adds
  double holes_mm = 0.0;       ///< taken off round holes, which become wider; negative makes them narrower
  double least_hole_mm = 0.0;  ///< wider holes stay as they are; 0 for none
  double shrink_xy = 0.0;      ///< shares by which the print shrinks as it cools, in the layers
  double shrink_z = 0.0;       ///< and across them
};

/// Adds the keys first_layer.*.
void describe(SettingsSchema& schema, FirstLayerSettings& settings);
/// Adds the keys compensation.*.
void describe(SettingsSchema& schema, CompensationSettings& settings);

}  // namespace lamina
