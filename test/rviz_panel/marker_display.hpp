// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <map>
#include <string>
#include <utility>

namespace lamina::test {

/// What a display of RViz holds of a topic.
class MarkerDisplay {
 public:
  explicit MarkerDisplay(const std::string& topic)
      : subscriber_(node_.subscribe<visualization_msgs::MarkerArray>(
            topic, 100,
            boost::function<void(const visualization_msgs::MarkerArrayConstPtr&)>(
                [this](const visualization_msgs::MarkerArrayConstPtr& array) { take(*array); }))) {}

  /// Lines of one namespace.
  std::size_t segments(const std::string& name) {
    return countIf([&](const std::string& held) { return held == name; });
  }
  /// Lines of all that is deposited.
  std::size_t segments() {
    return countIf([](const std::string& held) { return held != "travel"; });
  }

 private:
  template <class Wanted>
  std::size_t countIf(const Wanted& isWanted) {
    ros::spinOnce();
    std::size_t points = 0;
    for (const auto& held : held_)
      if (isWanted(held.first.first)) points += held.second.points.size();
    return points / 2;
  }

  void take(const visualization_msgs::MarkerArray& array) {
    for (const auto& marker : array.markers) {
      if (marker.action == marker.DELETEALL) held_.clear();
      if (marker.action == marker.DELETE) held_.erase({marker.ns, marker.id});
      if (marker.action == marker.ADD) held_[{marker.ns, marker.id}] = marker;
    }
  }

  ros::NodeHandle node_;
  std::map<std::pair<std::string, int>, visualization_msgs::Marker> held_;
  ros::Subscriber subscriber_;
};

}  // namespace lamina::test
