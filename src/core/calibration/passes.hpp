// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/calibration/sensor_recording.hpp"

namespace lamina {

/// A straight run of the nozzle at the usual speed.
struct Pass {
  double begin_s = 0.0;
  double end_s = 0.0;
  double sense = 1.0;  ///< along the travel, or -1 against it
};

/// The passes of a motion, in their order.
struct Passes {
  Point2 travel = Point2::UnitY();  ///< of unit length [bed]
  double speed_mm_s = 0.0;          ///< the usual one
  std::vector<Pass> runs;
};

/// Finds the direction in which the nozzle travels longest and its runs there and back: level, within half
/// of the usual speed, at least a fifth as long as the longest. No runs if the nozzle rests.
/// @param poses  ascending in time
Passes passesOf(const std::vector<RecordedPose>& poses);

}  // namespace lamina
