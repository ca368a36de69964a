// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/calibration/sensor_recording.hpp"

namespace lamina {

/// A straight run of the nozzle at its usual speed.
struct Pass {
  double begin_s = 0.0;
  double end_s = 0.0;
  double sense = 1.0;  ///< 1 along `travel`, -1 against it
};

/// The passes of a motion, in their order.
struct Passes {
  Point2 travel = Point2::UnitY();  ///< direction of the passes, of unit length [bed frame]
  double speed_mm_s = 0.0;          ///< usual speed
  std::vector<Pass> runs;
};

/// Finds the direction in which the nozzle travels longest, and the runs in this direction and its opposite
/// that are level, at the usual speed within half of it, and at least a fifth as long as the longest run. No
/// passes if the nozzle rests.
/// @param poses  ascending in time
Passes passesOf(const std::vector<RecordedPose>& poses);

}  // namespace lamina
