// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How the nozzle is held over inclined layers.
enum class ToolAxis {
  Normal,  ///< along the layers' normal
  Down,    ///< straight down, by a head that cannot tilt
};

/// How the layers lie: turned by `angle_deg` about a horizontal axis (`partFromLayers`).
struct PlaneSettings {
  double angle_deg = 0.0;
  double axis_heading_deg = 0.0;  ///< of that axis, from x towards y: 0 is x, 90 is y
  ToolAxis tool_axis = ToolAxis::Normal;
};

/// What says how high the layers of a stack are.
enum class LayerHeights {
  Equal,     ///< `layer_height_mm`
  Adaptive,  ///< the part's slopes (`adaptiveLayers`)
  File,      ///< a table (`readHeightTable`)
};

/// How high layers may be where their heights follow the part.
struct AdaptiveSettings {
  double cusp_mm = 0.1;  ///< greatest step that a layer leaves on the surface, along its normal
  double least_mm = 0.1;
  double greatest_mm = 0.3;
  double greatest_ratio = 1.5;  ///< of the heights of neighbouring layers
  double quantum_mm = 0.0;      ///< heights are multiples of it; 0 for any height
};

/// How a part is cut into layers.
struct SlicingSettings {
  /// Kind of layers, by its name; `slicingModes` holds those there are. The job describes its key.
  std::string mode = "planar";
  PlaneSettings plane;
  double layer_height_mm = 0.2;
  double first_layer_height_mm = 0.2;
  LayerHeights heights = LayerHeights::Equal;  ///< of plane layers
  std::string heights_file;                    ///< the table, with `heights` File
  AdaptiveSettings adaptive;
};

/// Adds the keys slicing.*, but for `slicing.mode`, and adaptive.*.
void describe(SettingsSchema& schema, SlicingSettings& settings);

/// @throws InvalidConfig if the least height is above the greatest, or a table is asked for and not named, or
/// named and not asked for
void requireConsistent(const SlicingSettings& settings);

}  // namespace lamina
