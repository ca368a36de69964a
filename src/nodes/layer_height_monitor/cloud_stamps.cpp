// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_stamps.hpp"

#include <algorithm>

namespace lamina {

void CloudStamps::add(const ros::Time& stamp) {
  if (stamp.isZero()) return;
  if (!last_.empty()) reached_ = std::max(reached_, std::min(last_.back(), stamp));
  last_.push_back(stamp);
  if (last_.size() > kRemembered) last_.pop_front();
}

bool CloudStamps::haveReached(const ros::Time& stamp) const {
  return stamp <= reached_ || std::find(last_.begin(), last_.end(), stamp) != last_.end();
}

}  // namespace lamina
