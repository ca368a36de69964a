// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/streaming/emulator/emulated_motion.hpp"

namespace lamina {

/// The nozzle at one instant of a motion.
struct MotionSample {
  double time_s = 0.0;               ///< machine time
  Point3 position = Point3::Zero();  ///< [mm, bed]
};

/// Instants along a motion, evenly in distance, no further apart than `spacing_mm`; the last one is its end,
/// the start is left out. A motion in place gives its end only.
std::vector<MotionSample> samplesOf(const ExecutedMotion& motion, double spacing_mm);

}  // namespace lamina
