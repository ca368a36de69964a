// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/pose_watch.hpp"

#include <cmath>

#include "control/run/stamps.hpp"

namespace lamina {

void PoseWatch::hear(std::int64_t stamp_ns, const std::optional<std::int64_t>& tip_ns) {
  const bool says_nothing = !tip_ns || secondsFrom(stamp_ns, *tip_ns) > kClockBack;
  // A stamp far off the one before is garbled, or the first one by another clock.
  const bool is_first = !last_ns_ || std::abs(secondsFrom(*last_ns_, stamp_ns)) > kClockBack;
  last_ns_ = stamp_ns;
  if (!says_nothing)
    first_ns_.reset();
  else if (!first_ns_ || is_first)
    first_ns_ = stamp_ns;
  was_without_any_ = !tip_ns;
}

double PoseWatch::blind(const std::optional<std::int64_t>& tip_ns) const {
  if (!last_ns_) return 0.0;
  const std::int64_t since = isWithoutPose(tip_ns) ? *first_ns_ : tip_ns.value_or(*last_ns_);
  return secondsFrom(since, *last_ns_);
}

bool PoseWatch::isWithoutPose(const std::optional<std::int64_t>& tip_ns) const {
  return first_ns_ && !(was_without_any_ && tip_ns);
}

}  // namespace lamina
