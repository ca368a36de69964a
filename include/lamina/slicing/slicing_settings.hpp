// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Direction of the nozzle over inclined layers.
enum class ToolAxis {
  Normal,  ///< along the normal of the layers
  Down,    ///< vertical, for a head that cannot tilt
};

/// Inclination of the layers: they are rotated about a horizontal axis (`partFromLayers`).
struct PlaneSettings {
  double angle_deg = 0.0;         ///< angle of the rotation; 0 for level layers
  double axis_heading_deg = 0.0;  ///< heading of the axis, from x towards y: 0 is x, 90 is y
  ToolAxis tool_axis = ToolAxis::Normal;
};

/// How the heights of plane layers are determined.
enum class LayerHeights {
  Equal,     ///< `layer_height_mm`, the same for all but the first
  Adaptive,  ///< the slopes of the part (`adaptiveLayers`)
  File,      ///< a table (`readHeightTable`)
};

/// Limits of the heights of layers that follow the slopes of the part.
struct AdaptiveSettings {
  double cusp_mm = 0.1;         ///< greatest step that a layer leaves on the surface, along its normal
  double least_mm = 0.1;        ///< least height
  double greatest_mm = 0.3;     ///< greatest height
  double greatest_ratio = 1.5;  ///< greatest ratio of the heights of neighbouring layers, higher to lower
  double quantum_mm = 0.0;      ///< length of which heights are multiples; 0 for any height
};

/// How a part is cut into layers.
struct SlicingSettings {
  /// Name of the kind of layers, one of `slicingModes`. Its key is added by the job, not by `describe`.
  std::string mode = "planar";
  PlaneSettings plane;
  double layer_height_mm = 0.2;
  double first_layer_height_mm = 0.2;
  LayerHeights heights = LayerHeights::Equal;  ///< used for plane layers only
  std::string heights_file;                    ///< path of the table if `heights` is File; else empty
  AdaptiveSettings adaptive;
};

/// Adds the keys slicing.*, except `slicing.mode`, and the keys adaptive.*.
void describe(SettingsSchema& schema, SlicingSettings& settings);

/// @throws InvalidConfig if the least height is above the greatest, if `heights` is File without a
///   `heights_file`, or if it is not File with a `heights_file`
void requireConsistent(const SlicingSettings& settings);

}  // namespace lamina
