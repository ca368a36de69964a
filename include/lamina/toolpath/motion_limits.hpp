// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Limits within which a machine moves its nozzle.
struct MotionLimits {
  double acceleration_mm_s2 = 1500.0;         ///< along the path, while depositing
  double travel_acceleration_mm_s2 = 3000.0;  ///< along the path, while travelling
  /// Determines the speed at corners (`junctionSpeed`): the distance between the corner and an arc that
  /// rounds it at this speed, with these accelerations.
  double junction_deviation_mm = 0.02;
};

/// Adds the keys motion.*.
void describe(SettingsSchema& schema, MotionLimits& limits);

}  // namespace lamina
