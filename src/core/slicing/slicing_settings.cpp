// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/slicing_settings.hpp"

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

void describe(SettingsSchema& schema, PlaneSettings& plane) {
  schema.number("slicing.plane.angle_deg", plane.angle_deg, {0.0, 75.0},
                "Inclination of the layers; 0 are level ones.");
  schema.number("slicing.plane.axis_heading_deg", plane.axis_heading_deg, {-360.0, 360.0},
                "Horizontal axis about which they are turned: 0 is x, 90 is y, 180 turns the other way.");
  schema.choice<ToolAxis>("slicing.plane.tool_axis", plane.tool_axis,
                          {{"normal", ToolAxis::Normal}, {"down", ToolAxis::Down}},
                          "Nozzle over inclined layers: along their normal, or straight down.");
  schema.renamed("slicing.plane.jet", "slicing.plane.tool_axis");
}

void describe(SettingsSchema& schema, AdaptiveSettings& adaptive) {
  const Bounds height = Bounds::above(0.0, 10.0);
  schema.number("adaptive.cusp_mm", adaptive.cusp_mm, height,
                "Greatest step that an adaptive layer leaves on the surface, along its normal.");
  schema.number("adaptive.least_mm", adaptive.least_mm, height, "Least height of adaptive layers.");
  schema.number("adaptive.greatest_mm", adaptive.greatest_mm, height, "Greatest height of adaptive layers.");
  schema.number("adaptive.greatest_ratio", adaptive.greatest_ratio, Bounds::above(1.0, 100.0),
                "Greatest ratio of the heights of neighbouring adaptive layers.");
  schema.number("adaptive.quantum_mm", adaptive.quantum_mm, {0.0, 10.0},
                "Adaptive heights are multiples of it, as of a motor's step; 0 for any height.");
}

}  // namespace

void describe(SettingsSchema& schema, SlicingSettings& settings) {
  const Bounds height = Bounds::above(0.0, 10.0);
  schema.number("slicing.layer_height_mm", settings.layer_height_mm, height,
                "Height of every layer but the first.");
  schema.number("slicing.first_layer_height_mm", settings.first_layer_height_mm, height,
                "Height of the first layer.");
  schema.choice<LayerHeights>(
      "slicing.heights", settings.heights,
      {{"equal", LayerHeights::Equal}, {"adaptive", LayerHeights::Adaptive}, {"file", LayerHeights::File}},
      "Whether plane layers are equally high, follow the part's slopes, or a table.");
  schema.text("slicing.heights_file", settings.heights_file,
              "Table of heights (CSV, as `lamina heights` writes it) with slicing.heights file.");
  describe(schema, settings.plane);
  describe(schema, settings.adaptive);
}

void requireConsistent(const SlicingSettings& settings) {
  const AdaptiveSettings& adaptive = settings.adaptive;
  if (adaptive.least_mm > adaptive.greatest_mm)
    throw InvalidConfig("adaptive.least_mm is " + numberText(adaptive.least_mm) +
                        " mm; must be at most adaptive.greatest_mm, " + numberText(adaptive.greatest_mm) +
                        " mm");
  if (settings.heights == LayerHeights::File && settings.heights_file.empty())
    throw InvalidConfig(
        "slicing.heights is 'file' without slicing.heights_file; expected a table of heights");
  if (settings.heights != LayerHeights::File && !settings.heights_file.empty())
    throw InvalidConfig("slicing.heights_file is '" + settings.heights_file +
                        "', which only slicing.heights 'file' reads; expected none");
}

}  // namespace lamina
