// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/stamped_events.hpp"

#include <algorithm>
#include <utility>

#include "control/run/cloud_order.hpp"

namespace lamina {

bool StampedEvents::Earlier::operator()(const StampedEvent& a, const StampedEvent& b) const {
  if (a.stamp_ns != b.stamp_ns) return a.stamp_ns < b.stamp_ns;
  if (!a.cloud || !b.cloud) {
    if (a.cloud || b.cloud) return !a.cloud;
    return std::lexicographical_compare(a.tip.begin(), a.tip.end(), b.tip.begin(), b.tip.end());
  }
  return compared(*a.cloud, *b.cloud) < 0;
}

void StampedEvents::add(const StampedTip& pose) {
  latest_tip_ns_ = std::max(latest_tip_ns_.value_or(pose.stamp_ns), pose.stamp_ns);
  insert({pose.stamp_ns, pose.tip, nullptr});
}

void StampedEvents::add(SensedCloud cloud) {
  const std::int64_t stamp_ns = cloud.stamp_ns;
  insert({stamp_ns, Point3::Zero(), std::make_shared<const SensedCloud>(std::move(cloud))});
}

void StampedEvents::insert(StampedEvent event) {
  latest_ns_ = std::max(latest_ns_.value_or(event.stamp_ns), event.stamp_ns);
  waiting_.insert(std::move(event));
}

std::optional<StampedEvent> StampedEvents::takeUntil(std::int64_t stamp_ns) {
  if (waiting_.empty() || waiting_.begin()->stamp_ns > stamp_ns) return std::nullopt;
  StampedEvent event = std::move(waiting_.extract(waiting_.begin()).value());
  taken_ns_ = event.stamp_ns;
  return event;
}

}  // namespace lamina
