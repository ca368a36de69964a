// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a part is cut into layers of equal growth.
struct VolumetricSettings {
  double cell_mm = 0.0;            ///< side of the cells in which growth is computed; 0 for one by the part
  double max_overhang_deg = 45.0;  ///< that the material takes, from the layer's own normal
  double overhang_used_deg =
      -1.0;  ///< that growth uses up on purpose; negative for 20 deg less, or as head and surface ask for
  double max_thickness = 2.0;  ///< of a layer, over `slicing.layer_height_mm`, which is the thinnest
  double max_tilt_deg = 80.0;  ///< of growth from up
  double deviation_deg =
      55.0;  ///< of the tool axis from the layer's normal, towards upright, so that the head is clear
  double sink_mm = 0.0;                  ///< by which the part is sunk into the bed and cut there
  double largest_pendant_percent = 0.5;  ///< of the volume, to which no growth leads, before it is refused
  double largest_unsupported_percent = 5.0;  ///< of the surface, before it is refused
  double largest_left_out_percent = 0.5;     ///< of what is deposited, where the head has no room
};

/// Adds the keys volumetric.*.
void describe(SettingsSchema& schema, VolumetricSettings& settings);

/// @throws InvalidConfig if growth is to use up more overhang than the material takes
void requireConsistent(const VolumetricSettings& settings);

}  // namespace lamina
