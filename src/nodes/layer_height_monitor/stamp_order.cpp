// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stamp_order.hpp"

namespace lamina {

void StampOrder::add(const sensor_msgs::PointCloud2ConstPtr& cloud, double now) {
  held_.insert({cloud->header.stamp, {cloud, now}});
}

std::vector<sensor_msgs::PointCloud2ConstPtr> StampOrder::due(double now) {
  auto end = held_.begin();
  for (auto each = held_.begin(); each != held_.end(); ++each)
    if (now - each->second.since >= kHold) end = std::next(each);
  std::vector<sensor_msgs::PointCloud2ConstPtr> clouds;
  for (auto each = held_.begin(); each != end; ++each) clouds.push_back(each->second.cloud);
  held_.erase(held_.begin(), end);
  return clouds;
}

}  // namespace lamina
