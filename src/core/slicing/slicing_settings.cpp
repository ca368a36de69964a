// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/slicing_settings.hpp"

namespace lamina {
namespace {

void describe(SettingsSchema& schema, PlaneSettings& plane) {
  schema.number("slicing.plane.angle_deg", plane.angle_deg, {0.0, 75.0, false},
                "Inclination of the layers; 0 are level ones.");
  schema.number("slicing.plane.axis_heading_deg", plane.axis_heading_deg, {-360.0, 360.0, false},
                "Horizontal axis about which they are turned: 0 is x, 90 is y, 180 turns the other way.");
  schema.choice<ToolAxis>("slicing.plane.tool_axis", plane.tool_axis,
                          {{"normal", ToolAxis::Normal}, {"down", ToolAxis::Down}},
                          "Nozzle over inclined layers: along their normal, or straight down.");
  schema.renamed("slicing.plane.jet", "slicing.plane.tool_axis");
}

}  // namespace

void describe(SettingsSchema& schema, SlicingSettings& settings) {
  const Bounds height{0.0, 10.0, true};
  schema.number("slicing.layer_height_mm", settings.layer_height_mm, height,
                "Height of every layer but the first.");
  schema.number("slicing.first_layer_height_mm", settings.first_layer_height_mm, height,
                "Height of the first layer.");
  describe(schema, settings.plane);
}

}  // namespace lamina
