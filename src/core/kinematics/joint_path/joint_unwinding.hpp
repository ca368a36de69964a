// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "kinematics/model/joint_ranges.hpp"

namespace lamina {

/// How joint values follow those before them.
struct WindLink {
  bool is_linked = false;   ///< the shorter way round; else there is no way, and nothing is asked of it
  bool may_rewind = false;  ///< whole turns may be put in between
  double rank = 0.0;        ///< of the places where they may, the one of highest rank is preferred
};

/// Where a joint runs out of its limits on a way on which it cannot be rewound.
struct WoundUp {
  std::size_t index = 0;
  std::size_t joint = 0;
};

/// Joint values with the whole turns that keep them within the limits.
struct Unwound {
  std::vector<JointValues> values;
  std::size_t rewinds = 0;
  std::vector<WoundUp> wound_up;  ///< the way goes on from there as from a start
};

/// Chooses whole turns stretch by stretch between rewinds: as few rewinds as can be, each at the place of
/// highest rank among those that keep them few, none of more turns than needed. Linear time.
/// @param values  each within the limits next to their middle; of size 0 where there are none
/// @param links   one per value, from the one before
Unwound unwind(std::vector<JointValues> values, const std::vector<WindLink>& links,
               const std::vector<JointRange>& ranges);

}  // namespace lamina
