// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/flow/desired_flow.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr double kInstant = 1e-9;  // s

}  // namespace

double DesiredFlow::Stretch::flowAt(double time_s) const {
  const double share = (time_s - start_s) / (end_s - start_s);
  return from_mm3_s + share * (to_mm3_s - from_mm3_s);
}

double DesiredFlow::Stretch::volume(double until_s) const {
  return 0.5 * (from_mm3_s + flowAt(until_s)) * (until_s - start_s);
}

void DesiredFlow::add(const SpeedProfile& profile, double section_mm2) {
  const double faster_s = (profile.cruise_mm_s - profile.entry_mm_s) / profile.acceleration_mm_s2;
  const double slower_s = (profile.cruise_mm_s - profile.exit_mm_s) / profile.acceleration_mm_s2;
  const double cruise = section_mm2 * profile.cruise_mm_s;
  addStretch(faster_s, section_mm2 * profile.entry_mm_s, cruise);
  addStretch(profile.duration_s - faster_s - slower_s, cruise, cruise);
  addStretch(slower_s, cruise, section_mm2 * profile.exit_mm_s);
}

void DesiredFlow::addStretch(double duration_s, double from_mm3_s, double to_mm3_s) {
  if (duration_s < kInstant) return;
  const double start_s = duration();
  const double before = volumeUntil(start_s);
  stretches_.push_back({start_s, start_s + duration_s, from_mm3_s, to_mm3_s, before});
}

std::vector<DesiredFlow::Stretch>::const_iterator DesiredFlow::stretchAt(double time_s) const {
  return std::lower_bound(stretches_.begin(), stretches_.end(), time_s - kInstant,
                          [](const Stretch& stretch, double time) { return stretch.end_s < time; });
}

double DesiredFlow::flowBefore(double time_s) const {
  const auto stretch = stretchAt(time_s);
  return time_s < kInstant || stretch == stretches_.end() ? 0.0
                                                          : stretch->flowAt(std::min(time_s, stretch->end_s));
}

double DesiredFlow::volumeUntil(double time_s) const {
  if (stretches_.empty() || time_s <= 0.0) return 0.0;
  const auto stretch = stretchAt(time_s);
  const Stretch& last = stretch == stretches_.end() ? stretches_.back() : *stretch;
  return last.volume_before_mm3 + last.volume(std::min(time_s, last.end_s));
}

std::vector<double> DesiredFlow::changesBetween(double from_s, double to_s) const {
  std::vector<double> changes;
  for (auto stretch = stretchAt(from_s); stretch != stretches_.end() && stretch->end_s < to_s - kInstant;
       ++stretch)
    if (stretch->end_s > from_s + kInstant) changes.push_back(stretch->end_s);
  return changes;
}

}  // namespace lamina
