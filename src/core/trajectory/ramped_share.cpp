// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/ramped_share.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

void RampedShare::lead(double share, double from_s, double ramp_s) {
  const double present = at(from_s);
  while (!corners_.empty() && corners_.back().time_s >= from_s) corners_.pop_back();
  corners_.push_back({from_s, present});
  corners_.push_back({from_s + ramp_s * std::abs(share - present), share});
}

double RampedShare::at(double time_s) const {
  const auto later = std::upper_bound(corners_.begin(), corners_.end(), time_s,
                                      [](double time, const Corner& corner) { return time < corner.time_s; });
  if (later == corners_.begin()) return 1.0;
  const Corner& before = *std::prev(later);
  if (later == corners_.end()) return before.share;
  const double passed = (time_s - before.time_s) / (later->time_s - before.time_s);
  return before.share + passed * (later->share - before.share);
}

}  // namespace lamina
