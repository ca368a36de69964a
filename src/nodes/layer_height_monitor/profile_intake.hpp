// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "transform_intake.hpp"

namespace lamina {

/// A profile where and when it was taken.
struct PlacedProfile {
  std::vector<Point3> points;              ///< [mm, bed frame]
  std::optional<double> nozzle_height_mm;  ///< of the nozzle tip [bed frame]; nothing if tf does not report
};

/// How often what happened to clouds and their points.
struct IntakeCounts {
  std::uint64_t received = 0;
  std::uint64_t placed = 0;
  std::uint64_t lost = 0;             ///< missing in the publisher's sequence
  std::uint64_t untransformable = 0;  ///< too old for tf, or pushed out of the queue while waiting for it
  std::uint64_t without_frame = 0;
  std::uint64_t malformed = 0;       ///< without the fields or bytes a cloud needs
  std::uint64_t without_nozzle = 0;  ///< of those placed
  std::uint64_t points_not_finite = 0;
  std::uint64_t waiting = 0;  ///< for tf, or for their turn
  std::string last_fault;     ///< what was wrong with the last malformed one
};

/// Receives profiles and places each on the bed by tf at its own stamp. The profiles of a frame come out in
/// the order of their stamps. (tf2_ros::MessageFilter is no choice: with thousands of clouds waiting it
/// crashes in BufferCore::testTransformableRequests, and it releases clouds in any order.)
class ProfileIntake {
 public:
  using Receiver = std::function<void(const PlacedProfile&)>;

  /// Subscribes to `profile` and to tf.
  /// @param queue  clouds that may wait for the node, and as many for tf
  ProfileIntake(ros::NodeHandle node, int queue, Receiver receiver);

  IntakeCounts counts() const;

 private:
  using CloudEvent = ros::MessageEvent<sensor_msgs::PointCloud2 const>;

  void onCloud(const CloudEvent& event);
  void countLost(const CloudEvent& event);
  void wait(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void passDue();
  void place(const sensor_msgs::PointCloud2& cloud);

  tf2::BufferCore buffer_;
  TransformIntake transforms_;
  std::size_t queue_;
  Receiver receiver_;
  std::map<std::string, std::multimap<ros::Time, sensor_msgs::PointCloud2ConstPtr>> waiting_;  ///< by frame
  IntakeCounts counts_;
  std::map<std::string, std::uint32_t> last_sequence_;  ///< by publisher
  ros::WallTimer timer_;
  ros::Subscriber subscriber_;
};

}  // namespace lamina
