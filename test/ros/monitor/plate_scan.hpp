// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "conversions.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "support/scanned_plates.hpp"
#include "tf/transform_lookup.hpp"

namespace lamina::test {

/// What a moving head and its sensor publish: a transform, and the clouds up to it.
struct ScanMessages {
  std::vector<geometry_msgs::TransformStamped> transforms;
  std::vector<sensor_msgs::PointCloud2> clouds;
};

/// One sweep along y over a box [mm, bed frame].
struct PlateScan {
  Box2 box{Point2(5, 5), Point2(25, 15)};
  double nozzle_height_mm = 1.3;
  std::function<double(const Point2&)> surface;
  ros::Time start{1000.0};
};

inline Eigen::Isometry3d nozzleFromSensor() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Point3(25, 0, -60);  // the nozzle's z points down
  return pose;
}

inline Eigen::Isometry3d bedFromNozzle(const Point3& tip) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = tip;
  pose.linear() = nozzleDown().toRotationMatrix();
  return pose;
}

inline geometry_msgs::TransformStamped stamped(const Eigen::Isometry3d& parent_from_child, const char* parent,
                                               const char* child, const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform = toTransformMessage(parent_from_child);
  return message;
}

/// A profile every 0.1 mm and a point every 0.1 mm, exact; a transform of the nozzle every 0.5 mm, so that
/// the poses of most profiles are interpolated.
inline ScanMessages scanMessages(const PlateScan& scan) {
  ScanMessages messages;
  const int steps = static_cast<int>((scan.box.size().y() + 2.0) / 0.1);
  for (int i = 0; i <= steps / 5 * 5; ++i) {
    const ros::Time stamp = scan.start + ros::Duration(0.002 * i);
    const double y = scan.box.low.y() - 0.95 + 0.1 * i;
    const double x = scan.box.centre().x();
    const Eigen::Isometry3d bed_from_nozzle = bedFromNozzle({x - 25, y, scan.nozzle_height_mm});
    const Eigen::Isometry3d sensor_from_bed = (bed_from_nozzle * nozzleFromSensor()).inverse();
    std::vector<Point3> points;
    for (double at = scan.box.low.x() - 0.95; at < scan.box.high.x() + 1.0; at += 0.1)
      points.push_back(sensor_from_bed * Point3(at, y, scan.surface({at, y})));
    messages.clouds.push_back(toCloudMessage(points));
    messages.clouds.back().header.frame_id = names::kSensorFrame;
    messages.clouds.back().header.stamp = stamp;
    if (i % 5 == 0)
      messages.transforms.push_back(stamped(bed_from_nozzle, names::kBedFrame, names::kNozzleFrame, stamp));
  }
  return messages;
}

/// The lift after a scan, with a profile that shows nothing: it ends the scan by the stamps.
inline ScanMessages liftAfter(const PlateScan& scan) {
  const ros::Time stamp = scan.start + ros::Duration(0.5);
  ScanMessages messages;
  messages.clouds = {toCloudMessage(std::vector<Point3>())};
  messages.clouds.back().header.frame_id = names::kSensorFrame;
  messages.clouds.back().header.stamp = stamp;
  const Point3 tip(scan.box.centre().x() - 25.0, scan.box.high.y(), scan.nozzle_height_mm + 5.0);
  messages.transforms = {stamped(bedFromNozzle(tip), names::kBedFrame, names::kNozzleFrame, stamp)};
  return messages;
}

/// Two plates of 20 x 10 mm, each followed by a scan pass.
inline lamina_msgs::Toolpath twoPlates() {
  const PlateScan scan;
  MachineToolpath placed;
  placed.toolpath = scannedPlates({scan.box, scan.box});
  placed.id = toolpathId(placed.toolpath);
  return toMessage(placed);
}

}  // namespace lamina::test
