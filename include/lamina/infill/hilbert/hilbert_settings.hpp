// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What the strategies of Hilbert curves ask for.
struct HilbertSettings {
  int angles = 1;  ///< turns of the curve that are tried for the fewest jumps
};

/// Adds the keys hilbert.*.
void describe(SettingsSchema& schema, HilbertSettings& settings);

}  // namespace lamina
