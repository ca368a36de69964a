// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Settings of the base of a vase.
struct VaseSettings {
  int base_layers = 3;                   ///< number of solid layers below the rising wall
  std::string base_strategy = "zigzag";  ///< infill strategy of these layers, inside one wall
};

/// Adds the keys vase.*.
void describe(SettingsSchema& schema, VaseSettings& settings);

}  // namespace lamina
