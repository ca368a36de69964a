// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings.hpp"

namespace lamina {

/// How a part is cut into layers.
struct SlicingSettings {
  double layer_height_mm = 0.2;
  double first_layer_height_mm = 0.2;
};

void describe(SettingsSchema& schema, SlicingSettings& settings);

}  // namespace lamina
