// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Settings of the strategies of Hilbert curves.
struct HilbertSettings {
  /// Number of orientations of the curve that are tried; the orientation with the fewest jumps is used.
  int angles = 1;
};

/// Adds the keys hilbert.*.
void describe(SettingsSchema& schema, HilbertSettings& settings);

}  // namespace lamina
