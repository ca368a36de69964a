// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// What is done about an overhang that no mark covers.
enum class UnmarkedOverhangs : std::uint8_t {
  ByAngle,  ///< supported if it leans more than `supports.angle_deg`
  LeftOut   ///< not supported
};

/// Areas in which supports are forced or blocked, by layer [frame of the layers], or empty.
struct SupportMarks {
  std::vector<Regions> never;   ///< overhangs there are not supported
  std::vector<Regions> always;  ///< overhangs of any angle there are supported; disjoint from `never`
  UnmarkedOverhangs unmarked = UnmarkedOverhangs::ByAngle;
};

}  // namespace lamina
