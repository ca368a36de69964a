// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/pose_watch.hpp"

#include <cmath>

#include "control/run/stamps.hpp"

namespace lamina {

double PoseWatch::hear(std::int64_t stamp_ns, const std::optional<std::int64_t>& tip_ns) {
  const bool says_nothing = !tip_ns || secondsFrom(stamp_ns, *tip_ns) > kClockBack;
  // A stamp far off the one before is garbled, or the first one by another clock.
  const bool is_first = !last_ns_ || std::abs(secondsFrom(*last_ns_, stamp_ns)) > kClockBack;
  last_ns_ = stamp_ns;
  if (!says_nothing)
    first_ns_.reset();
  else if (!first_ns_ || is_first)
    first_ns_ = stamp_ns;
  return secondsFrom(first_ns_.value_or(tip_ns.value_or(stamp_ns)), stamp_ns);
}

}  // namespace lamina
