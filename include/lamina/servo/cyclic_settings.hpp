// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How targets are played to a controller that takes one each cycle.
struct CyclicSettings {
  double brake_s = 0.3;              ///< in which a joint at its greatest speed comes to rest
  double start_tolerance_deg = 0.1;  ///< that a first point may be off where a joint is
  double late_cycles = 3.0;          ///< that a cycle may come late in motion
};

/// Adds the keys cyclic.*.
void describe(SettingsSchema& schema, CyclicSettings& settings);

}  // namespace lamina
