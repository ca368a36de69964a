// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>

#include "lamina/monitoring/height_monitor.hpp"
#include "messages.hpp"

namespace lamina {

/// A report as it is published.
/// @param counts  counts of all profiles since the toolpath arrived
lamina_msgs::LayerHeight toMessage(const LayerHeightReport& report, const std::string& toolpath_id,
                                   const lamina_msgs::ProfileCounts& counts);

/// Publishes what was measured.
///
/// measuring (lamina/Measuring, latched), layer_height (lamina/LayerHeight, latched), height_map
/// (sensor_msgs/PointCloud2, latched), height_deviation (sensor_msgs/Image, latched); where octomap_msgs is
/// installed, height_octomap (octomap_msgs/Octomap, latched)
class HeightTopics {
 public:
  explicit HeightTopics(ros::NodeHandle node);

  void publish(const LayerHeightReport& report, const std::string& toolpath_id,
               const lamina_msgs::ProfileCounts& counts);
  /// States that the node is ready for the print of a toolpath.
  /// @param toolpath_stamp  stamp of the toolpath's header
  void publishMeasuring(const std::string& toolpath_id, const ros::Time& toolpath_stamp);

  /// Marks the published maps as out of date.
  void outdateMaps();

  /// Whether a map that is out of date has a subscriber. Maps are large: they are published only for
  /// subscribers, also for those that connect later, even after the print.
  bool areMapsAwaited() const;

  /// Publishes the maps that are awaited.
  void publishMaps(const HeightMonitor& monitor);

 private:
  struct MapTopic {
    ros::Publisher publisher;
    bool is_outdated = false;

    bool isAwaited() const { return is_outdated && publisher && publisher.getNumSubscribers() > 0; }
    /// Whether the map is awaited; it counts as published from then on.
    bool take();
  };

  ros::Publisher measuring_;
  ros::Publisher layer_height_;
  MapTopic height_map_;
  MapTopic deviation_;
  MapTopic octomap_;
};

}  // namespace lamina
