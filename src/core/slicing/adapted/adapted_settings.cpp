// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adapted/adapted_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, AdaptedSettings& settings) {
  schema.number("adapted.step_mm", settings.step_mm, Bounds::above(0.0, 10.0),
                "Greatest distance between points of an adapted curve.");
  schema.integer("adapted.smoothing_window", settings.smoothing_window, {1, 9999},
                 "Points of an adapted curve that are averaged, an odd number; 1 is none.");
  schema.number("adapted.computing_height_mm", settings.computing_height_mm, {0.0, 10.0},
                "Height of the layers that are computed, a multiple of the layer height; those between are "
                "interpolated; 0 computes all.");
  schema.number("adapted.max_lean_deg", settings.max_lean_deg, Bounds::above(0.0, 80.0),
                "Greatest lean of walls from the vertical; parts whose walls lean more are refused.");
}

}  // namespace lamina
