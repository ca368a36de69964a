// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>

#include "lamina/monitoring/height_monitor.hpp"
#include "messages.hpp"

namespace lamina {

/// A report as it is published.
/// @param counts  of all profiles since the toolpath came
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
  /// All is ready for the print of a toolpath.
  /// @param toolpath_stamp  of its header
  void publishMeasuring(const std::string& toolpath_id, const ros::Time& toolpath_stamp);

  /// What was published of the maps is no longer true.
  void outdateMaps();

  /// Whether a map that is out of date has a subscriber. Maps are large: without one they are not published,
  /// and a subscriber that comes later, even after the print, is one for whom they are.
  bool areMapsAwaited() const;

  /// Publishes the maps that are awaited.
  void publishMaps(const HeightMonitor& monitor);

 private:
  struct MapTopic {
    ros::Publisher publisher;
    bool is_outdated = false;

    bool isAwaited() const { return is_outdated && publisher && publisher.getNumSubscribers() > 0; }
    /// Whether it is awaited; it counts as published from then on.
    bool take();
  };

  ros::Publisher measuring_;
  ros::Publisher layer_height_;
  MapTopic height_map_;
  MapTopic deviation_;
  MapTopic octomap_;
};

}  // namespace lamina
