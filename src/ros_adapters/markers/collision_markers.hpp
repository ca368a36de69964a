// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "lamina/verification/collision/clearance.hpp"

namespace lamina {

/// Markers of the first collision of each layer: in namespace `collision` a red arrow from the nozzle tip to
/// the material or the bed involved, and in `first_collision` a text at the first of all. The first marker
/// deletes those of an earlier report; a report without collisions has this one only.
///
/// @param frame  frame of the markers: that of the bed
visualization_msgs::MarkerArray collisionMarkers(const ClearanceReport& report, const std::string& frame);

}  // namespace lamina
