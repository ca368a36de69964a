// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "owner/owner_watch.hpp"

#include <utility>

#include "names.hpp"

namespace lamina {

OwnerWatch::OwnerWatch(ros::NodeHandle node, double grace_s) : grace_s_(grace_s) {
  if (grace_s > 0.0) status_ = node.subscribe(names::kPackmlStatus, 10, &OwnerWatch::onStatus, this);
}

void OwnerWatch::expect() {
  const std::lock_guard<std::mutex> lock(mutex_);
  heard_s_ = clock_.now();
  is_told_ = false;
}

void OwnerWatch::onStatus(const lamina_msgs::PackmlStatusConstPtr& /*status*/) { expect(); }

bool OwnerWatch::takeLoss() {
  if (grace_s_ <= 0.0) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool is_lost = clock_.now() - heard_s_ > grace_s_;
  return is_lost && !std::exchange(is_told_, true);
}

bool OwnerWatch::isLost() const {
  if (grace_s_ <= 0.0) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  return clock_.now() - heard_s_ > grace_s_;
}

}  // namespace lamina
