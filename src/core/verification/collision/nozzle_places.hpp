// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// A place of the nozzle on its way.
struct NozzlePlace {
  Point3 tip = Point3::Zero();  ///< [mm, bed frame]
  WaypointIndex at;             ///< there, or to which it moves
  std::size_t deposited = 0;    ///< boxes that are there (`depositedBoxes`)
};

/// All waypoints of a layer and places between them, `spacing_mm` apart at most, in the order of the motion.
/// @param deposited  boxes that are there when the layer begins
std::vector<NozzlePlace> nozzlePlaces(const Toolpath& toolpath, std::size_t layer, std::size_t deposited,
                                      const Eigen::Isometry3d& bed_from_part,
                                      const ClearanceSettings& settings);

}  // namespace lamina
