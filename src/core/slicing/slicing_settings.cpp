// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/slicing_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, SlicingSettings& settings) {
  const Bounds height{0.0, 10.0, true};
  schema.number("slicing.layer_height_mm", settings.layer_height_mm, height,
                "Height of every layer but the first.");
  schema.number("slicing.first_layer_height_mm", settings.first_layer_height_mm, height,
                "Height of the first layer.");
}

}  // namespace lamina
