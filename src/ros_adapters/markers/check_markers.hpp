// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "lamina/job/machine_check.hpp"

namespace lamina {

/// All waypoints that a machine or robot cannot run as RViz shows them: spheres in namespace `faulty` for
/// those out of reach or limits, singular, or that cannot be come to, orange; in namespace `colliding` for
/// collisions, red; in `first_finding` a text at the first of all. The first marker deletes those of an
/// earlier check; a clear one gives that alone.
visualization_msgs::MarkerArray checkMarkers(const MachineCheck& check);

}  // namespace lamina
