// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/waypoint_text.hpp"

namespace lamina {

std::string toText(const WaypointIndex& at) {
  return "layer " + std::to_string(at.layer) + ", path " + std::to_string(at.path) + ", waypoint " +
         std::to_string(at.waypoint);
}

}  // namespace lamina
