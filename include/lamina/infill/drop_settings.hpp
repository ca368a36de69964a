// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings.hpp"

namespace lamina {

/// What the strategies of drops ask for.
struct DropSettings {
  double diameter_mm = 0.4;
  double pitch_mm = 0.4;  ///< between neighbouring drops of a line
};

/// Adds the keys drops.*.
void describe(SettingsSchema& schema, DropSettings& settings);

}  // namespace lamina
