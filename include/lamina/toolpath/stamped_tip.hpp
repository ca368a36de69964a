// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Position of the nozzle tip at an instant.
struct StampedTip {
  std::int64_t stamp_ns = 0;
  Point3 tip = Point3::Zero();  ///< [mm, bed frame]
};

}  // namespace lamina
