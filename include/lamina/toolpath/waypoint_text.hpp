// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/toolpath/waypoint_index.hpp"

namespace lamina {

/// The name of a waypoint in messages: "layer 3, path 0, waypoint 12".
std::string toText(const WaypointIndex& at);

}  // namespace lamina
