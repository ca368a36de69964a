// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "kinematics/model/joint_ranges.hpp"

namespace lamina {

/// How a set of joint values follows the previous set.
struct WindLink {
  /// Whether the joints move there by the shorter rotation; otherwise there is no motion between the two
  /// sets.
  bool is_linked = false;
  bool may_rewind = false;  ///< whether joints may be turned back by whole turns (rewound) between the two
  double rank = 0.0;        ///< preference as a place for rewinding; higher is better
};

/// A place where a joint would leave its limits and no rewinding is allowed before it.
struct WoundUp {
  std::size_t index = 0;
  std::size_t joint = 0;
  /// Range that the joint needs from the last place where it could be rewound to the next [rad], counted
  /// continuously over whole turns from a value within the limits.
  double lowest = 0.0;
  double highest = 0.0;
};

/// Joint values with the whole turns that keep them within the limits.
struct Unwound {
  std::vector<JointValues> values;
  std::size_t rewinds = 0;
  std::vector<WoundUp> wound_up;  ///< at each, values continue as at a start
};

/// Chooses the whole turns of rotary joints stretch by stretch between rewinds: with as few rewinds as
/// possible, each at the place of highest rank that keeps their number least, and none by more turns than
/// needed. Takes linear time.
/// @param values  rotary values are the equivalent ones within the limits nearest to the middle; of size 0
///   where there is no solution
/// @param links   for each set of values, how it follows the one before
Unwound unwind(std::vector<JointValues> values, const std::vector<WindLink>& links,
               const std::vector<JointRange>& ranges);

}  // namespace lamina
