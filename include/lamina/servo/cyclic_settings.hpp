// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a trajectory is played to a controller that needs a target each cycle.
struct CyclicSettings {
  double brake_s = 0.3;              ///< time in which a joint comes to rest from its greatest speed
  double start_tolerance_deg = 0.1;  ///< greatest distance of a first point from a joint's position
  double late_cycles = 3.0;          ///< greatest lateness of a cycle in motion, in cycles
};

/// Adds the keys cyclic.*.
void describe(SettingsSchema& schema, CyclicSettings& settings);

}  // namespace lamina
