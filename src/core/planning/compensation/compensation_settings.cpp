// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/compensation/compensation_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, FirstLayerSettings& first) {
  schema.number("first_layer.width_factor", first.width_factor, {0.1, 5.0},
                "Factor on the width of the first layer's beads.");
  schema.number("first_layer.feed_factor", first.feed_factor, Bounds::above(0.0, 10.0),
                "Factor on the feeds of the first layer, travels excepted.");
  schema.number("first_layer.flow", first.flow, {0.1, 5.0},
                "Factor on what is deposited in the first layer.");
  schema.number("first_layer.nozzle_temperature_c", first.nozzle_temperature_c, {0.0, 500.0},
                "Nozzle temperature in the first layer; 0 for program.nozzle_temperature_c.");
  schema.number("first_layer.bed_temperature_c", first.bed_temperature_c, {0.0, 200.0},
                "Bed temperature in the first layer; 0 for program.bed_temperature_c.");
  schema.number("first_layer.inset_mm", first.inset_mm, {0.0, 10.0},
                "By how much the first layer's outlines are shrunk, except where little would be left.");
  schema.integer("first_layer.inset_layers", first.inset_layers, {1, 1000},
                 "So many layers over which that tapers to 0.");
}

void describe(SettingsSchema& schema, CompensationSettings& compensation) {
  schema.number("compensation.outline_mm", compensation.outline_mm, {-10.0, 10.0},
                "What is taken off outer outlines; negative adds.");
  schema.number("compensation.holes_mm", compensation.holes_mm, {-10.0, 10.0},
                "What is taken off round holes, so that they become wider; negative makes them narrower.");
  schema.number("compensation.least_hole_mm", compensation.least_hole_mm, {0.0, 10000.0},
                "Holes wider than this stay as they are; 0 for none.");
  schema.number("compensation.shrink_xy", compensation.shrink_xy, {-0.5, 0.5},
                "Share by which a print shrinks in the plane of its layers; the part is made larger.");
  schema.number("compensation.shrink_z", compensation.shrink_z, {-0.5, 0.5},
                "Share by which it shrinks across its layers.");
}

}  // namespace lamina
