// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/contour/smoothing_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, SmoothingSettings& settings) {
  schema.number("smoothing.window_mm", settings.window_mm, {0.0, 1000.0},
                "Length of the infill round each corner that a curve replaces; 0 keeps corners.");
  schema.number("smoothing.step_mm", settings.step_mm, {0.001, 1000.0},
                "Between neighbouring points on these curves.");
  schema.number("smoothing.tolerance_mm", settings.tolerance_mm, {0.0, 10.0},
                "How far points of the infill that are left out may lie from it; 0 leaves out none.");
}

}  // namespace lamina
