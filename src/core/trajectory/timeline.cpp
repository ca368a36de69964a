// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/timeline.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

void Timeline::append(Phase phase, double duration_s) {
  if (!(duration_s > 0.0)) return;
  phase.time_s = end_s_;
  end_s_ += duration_s;
  phases_.push_back(phase);
}

void Timeline::append(const Timeline& other, std::size_t from, double share) {
  for (std::size_t i = from; i < other.phases_.size(); ++i) {
    Phase phase = other.phases_[i];
    const double duration_s = other.endOf(i) - phase.time_s;
    if (phase.kind != PhaseKind::Move) {
      append(phase, duration_s);
      continue;
    }
    phase.speed *= share;
    phase.acceleration *= share * share;
    append(phase, duration_s / share);
  }
}

void Timeline::appendStretch(const MotionPlace& start, double length, double exit2) {
  const double exit = std::sqrt(exit2);
  const double sum = start.speed + exit;
  if (!(length > 0.0 && sum > 0.0)) return;
  const double duration_s = 2.0 * length / sum;
  append({0.0, start.curve, start.along, start.speed, (exit - start.speed) / duration_s, start.span,
          PhaseKind::Move},
         duration_s);
}

void Timeline::cut(double time_s) {
  const auto later = std::lower_bound(phases_.begin(), phases_.end(), time_s,
                                      [](const Phase& phase, double time) { return phase.time_s < time; });
  phases_.erase(later, phases_.end());
  end_s_ = std::min(end_s_, std::max(0.0, time_s));
}

std::size_t Timeline::phaseAt(double time_s) const {
  const auto later = std::upper_bound(phases_.begin() + 1, phases_.end(), time_s,
                                      [](double time, const Phase& phase) { return time < phase.time_s; });
  return static_cast<std::size_t>(later - phases_.begin() - 1);
}

MotionPlace Timeline::placeAt(double time_s) const {
  const std::size_t index = phaseAt(time_s);
  const Phase& phase = phases_[index];
  const double duration_s = endOf(index) - phase.time_s;
  const double local_s = std::clamp(time_s - phase.time_s, 0.0, duration_s);
  const bool is_running = time_s >= 0.0 && time_s < end_s_;
  return {phase.curve,
          phase.span,
          std::clamp(phase.alongAfter(local_s), 0.0, phase.curve->length(phase.span)),
          is_running ? std::max(0.0, phase.speedAfter(local_s)) : 0.0,
          is_running ? phase.acceleration : 0.0,
          phase.kind};
}

}  // namespace lamina
