// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "lamina/verification/collision/clearance.hpp"

namespace lamina {

/// The first collision of each layer as RViz shows it: in the namespace `collision` an arrow from the nozzle
/// tip to the material it is about, or to the bed, red; in `first_collision` the text of the first of all.
/// The first marker deletes those of an earlier report; one without collisions gives that alone.
///
/// @param frame  that the markers are given in: the frame of the bed
visualization_msgs::MarkerArray collisionMarkers(const ClearanceReport& report, const std::string& frame);

}  // namespace lamina
