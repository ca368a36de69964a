// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "lamina/job/machine_check.hpp"

namespace lamina {

/// Markers of all waypoints that a machine or robot cannot run: orange spheres in namespace `faulty` for
/// those out of reach or limits, singular, or not reachable from the one before; red spheres in `colliding`
/// for collisions; and in `first_finding` a text at the first of all. The first marker deletes those of an
/// earlier check; a check without findings has this one only.
visualization_msgs::MarkerArray checkMarkers(const MachineCheck& check);

}  // namespace lamina
