// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/cyclic_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, CyclicSettings& settings) {
  schema.number("cyclic.brake_s", settings.brake_s, {0.02, 5.0},
                "Time in which a joint comes to rest from its greatest speed.");
  schema.number("cyclic.start_tolerance_deg", settings.start_tolerance_deg, {0.001, 5.0},
                "How far the first point of a goal may be off where a joint is or is planned to be.");
  schema.number("cyclic.late_cycles", settings.late_cycles, {1.0, 1e5},
                "Cycles that a target may come late in motion; later, the robot is braked along the path.");
}

}  // namespace lamina
