// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Treatment of an overhang that no mark covers.
enum class UnmarkedOverhangs : std::uint8_t {
  ByAngle,  ///< supported if it leans more than `supports.angle_deg`
  LeftOut   ///< not supported
};

/// Areas in which supports are forced or blocked, one entry per layer [frame of the layers]; empty if there
/// are none.
struct SupportMarks {
  std::vector<Regions> never;   ///< areas where overhangs are not supported
  std::vector<Regions> always;  ///< areas where overhangs of any angle are supported; disjoint from `never`
  UnmarkedOverhangs unmarked = UnmarkedOverhangs::ByAngle;
};

}  // namespace lamina
