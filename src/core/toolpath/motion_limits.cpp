// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/motion_limits.hpp"

namespace lamina {

void describe(SettingsSchema& schema, MotionLimits& limits) {
  schema.number("motion.acceleration_mm_s2", limits.acceleration_mm_s2, Bounds::above(0.0, 1e6),
                "Acceleration along the path while depositing.");
  schema.number("motion.travel_acceleration_mm_s2", limits.travel_acceleration_mm_s2, Bounds::above(0.0, 1e6),
                "Acceleration along the path while travelling.");
  schema.number("motion.junction_deviation_mm", limits.junction_deviation_mm, Bounds::above(0.0, 10.0),
                "How far a corner would be rounded at the speed it is run with.");
}

}  // namespace lamina
