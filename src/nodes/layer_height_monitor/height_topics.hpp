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

  /// The maps go only to topics that somebody listens to: they are large.
  void publishMaps(const HeightMonitor& monitor);

 private:
  ros::Publisher measuring_;
  ros::Publisher layer_height_;
  ros::Publisher height_map_;
  ros::Publisher deviation_;
  ros::Publisher octomap_;
};

}  // namespace lamina
