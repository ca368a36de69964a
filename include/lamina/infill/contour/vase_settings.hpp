// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What a vase stands on.
struct VaseSettings {
  int base_layers = 3;                   ///< solid ones below the rising wall
  std::string base_strategy = "zigzag";  ///< that fills them inside one wall
};

/// Adds the keys vase.*.
void describe(SettingsSchema& schema, VaseSettings& settings);

}  // namespace lamina
