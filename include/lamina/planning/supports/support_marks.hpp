// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// What becomes of an overhang that no mark covers.
enum class UnmarkedOverhangs : std::uint8_t {
  ByAngle,  ///< held up if it leans more than `supports.angle_deg`
  LeftOut   ///< not held up
};

/// Where a part is held up, or not, whatever its overhangs are: by layer [frame of the layers], or empty.
struct SupportMarks {
  std::vector<Regions> never;   ///< what hangs there is not held up
  std::vector<Regions> always;  ///< what hangs there at all is held up; disjoint from `never`
  UnmarkedOverhangs unmarked = UnmarkedOverhangs::ByAngle;
};

}  // namespace lamina
