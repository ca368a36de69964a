// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings.hpp"

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

/// How a part is cut into layers.
struct SlicingSettings {
  /// Kind of layers, by its name; `slicingModes` holds those there are. The job describes its key.
  std::string mode = "planar";
  PlaneSettings plane;
  double layer_height_mm = 0.2;
  double first_layer_height_mm = 0.2;
};

/// Adds the keys slicing.*, but for `slicing.mode`.
void describe(SettingsSchema& schema, SlicingSettings& settings);

}  // namespace lamina
