// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace lamina {

/// Where a waypoint stands in a toolpath; all count from 0.
struct WaypointIndex {
  std::size_t layer = 0;
  std::size_t path = 0;
  std::size_t waypoint = 0;
};

}  // namespace lamina
