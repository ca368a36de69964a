// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>

#include <string>

#include "ros/monitor/plate_scan.hpp"
#include "support/sensed_wall.hpp"

namespace lamina::test {

inline ros::Time timeOf(std::int64_t stamp_ns) {
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(stamp_ns));
  return time;
}

inline lamina_msgs::Toolpath toolpathMessage(const SensedWall& wall) {
  MachineToolpath placed;
  placed.toolpath = wall.part.toolpath;
  placed.id = wall.part.toolpath_id;
  placed.machine = "cartesian_gantry";
  return toMessage(placed);
}

/// As recorded: a sensor whose clock is ahead by the offset.
inline sensor_msgs::PointCloud2 cloudMessage(const SensedCloud& cloud, double time_offset_s = 0.0) {
  sensor_msgs::PointCloud2 message = toCloudMessage(cloud.profiles.at(0));
  message.header.frame_id = names::kSensorFrame;
  message.header.stamp = timeOf(cloud.stamp_ns) + ros::Duration(time_offset_s);
  return message;
}

inline tf2_msgs::TFMessage nozzleMessage(const StampedTip& pose) {
  tf2_msgs::TFMessage message;
  message.transforms = {
      stamped(bedFromNozzle(pose.tip), names::kBedFrame, names::kNozzleFrame, timeOf(pose.stamp_ns))};
  return message;
}

/// Where the sensor of these walls sits [mm].
inline Eigen::Isometry3d sensorOfWall() {
  const Point3 origin = Point3::Zero();
  return bedFromNozzle(origin).inverse() * sensorOver(origin);
}

/// @param off_mm  by which tf has the sensor elsewhere than it is, in the frame of the nozzle
inline tf2_msgs::TFMessage sensorMessage(const Point3& off_mm = Point3::Zero()) {
  tf2_msgs::TFMessage message;
  message.transforms = {stamped(Eigen::Translation3d(off_mm) * sensorOfWall(), names::kNozzleFrame,
                                names::kSensorFrame, ros::Time(1.0))};
  return message;
}

/// The print as a recorder has it, transforms 20 ms late.
inline void writeBag(const std::string& path, const SensedWall& wall, double time_offset_s = 0.0,
                     const Point3& sensor_off_mm = Point3::Zero()) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.setCompression(rosbag::compression::LZ4);
  const ros::Time start = timeOf(wall.tips.front().stamp_ns);
  bag.write(names::kToolpath, start - ros::Duration(1.0), toolpathMessage(wall));
  bag.write("/tf_static", start - ros::Duration(0.9), sensorMessage(sensor_off_mm));
  for (const SensedCloud& cloud : wall.clouds)
    bag.write(names::kProfile, timeOf(cloud.stamp_ns), cloudMessage(cloud, time_offset_s));
  for (const StampedTip& pose : wall.tips)
    bag.write("/tf", timeOf(pose.stamp_ns) + ros::Duration(0.02), nozzleMessage(pose));
}

}  // namespace lamina::test
