// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/verification/collision/clearance_settings.hpp"
#include "lamina/verification/collision/joint_clearance.hpp"

namespace lamina {

/// How many boxes (`depositedBoxes`) are there when the nozzle sets out for each station of a joint path.
/// What it has deposited within the last one and a half bead widths of its way is soft still and no obstacle.
std::vector<std::size_t> depositedBeforeStations(const JointRun& run, double tolerance_mm);

/// Joint values at which to look on the way to a station, the station last: the station alone if it is the
/// first, or the one before has no values; nothing if it has none itself.
std::vector<JointValues> placesBefore(const JointRun& run, std::size_t station,
                                      const ClearanceSettings& settings);

}  // namespace lamina
