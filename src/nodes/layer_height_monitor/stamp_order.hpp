// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <map>
#include <vector>

namespace lamina {

/// Puts clouds back into the order of their stamps. The transform filter releases all clouds that one
/// transform makes usable at once, in any order; each is held for a moment, until those it came with are
/// there too.
class StampOrder {
 public:
  static constexpr double kHold = 0.1;  ///< [s] of real time

  /// @param now  [s] of any steady clock
  void add(const sensor_msgs::PointCloud2ConstPtr& cloud, double now);

  /// Those held long enough and all with earlier stamps, in the order of their stamps.
  std::vector<sensor_msgs::PointCloud2ConstPtr> due(double now);

  std::size_t held() const { return held_.size(); }

 private:
  struct Held {
    sensor_msgs::PointCloud2ConstPtr cloud;
    double since;
  };
  std::multimap<ros::Time, Held> held_;
};

}  // namespace lamina
