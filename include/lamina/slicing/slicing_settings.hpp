// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings.hpp"

namespace lamina {

/// What kind of layers a part is cut into.
enum class SlicingMode {
  Planar,       ///< in parallel planes: level, or as `slicing.plane` says
  Inclined,     ///< the same, where `slicing.plane` must incline them
  Adapted,      ///< of a single wall that grows along the tool axis
  Curved,       ///< equidistant to the part's lower and upper surface, level between them
  Conformal,    ///< equidistant to a given base surface
  HeightField,  ///< bent upwards to follow the part's upper side, for machines that cannot tilt
  Auto,         ///< one of these, chosen by the part and the machine
};

/// As written in settings: "planar", "heightfield".
const char* toString(SlicingMode mode);

/// Whether its layers lie in parallel planes.
bool hasPlaneLayers(SlicingMode mode);

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
  SlicingMode mode = SlicingMode::Planar;
  PlaneSettings plane;
  double layer_height_mm = 0.2;
  double first_layer_height_mm = 0.2;
};

void describe(SettingsSchema& schema, SlicingSettings& settings);

}  // namespace lamina
