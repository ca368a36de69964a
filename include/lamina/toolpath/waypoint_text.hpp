// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/toolpath/waypoint_index.hpp"

namespace lamina {

/// "layer 3, path 0, waypoint 12": as messages name waypoints.
std::string toText(const WaypointIndex& at);

}  // namespace lamina
