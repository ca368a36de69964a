// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/geometry/vector.hpp"
#include "stamp_order.hpp"
#include "transform_intake.hpp"

namespace lamina {

/// A profile where and when it was taken.
struct PlacedProfile {
  std::vector<Point3> points;              ///< [mm, bed frame]
  std::optional<double> nozzle_height_mm;  ///< of the nozzle tip [bed frame]; nothing if tf does not tell
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

/// Receives profiles and places each on the bed by tf at its own stamp. Profiles come out in the order of
/// their stamps.
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
  void onReady(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void onFailure(tf2_ros::FilterFailureReason reason);
  void countLost(const CloudEvent& event);
  void passDue();
  void place(const sensor_msgs::PointCloud2& cloud);

  tf2_ros::Buffer buffer_;
  TransformIntake transforms_;
  tf2_ros::MessageFilter<sensor_msgs::PointCloud2> filter_;
  Receiver receiver_;
  SteadyClock clock_;
  StampOrder order_;
  IntakeCounts counts_;
  std::uint64_t ready_ = 0;
  std::map<std::string, std::uint32_t> last_sequence_;  ///< by publisher
  ros::WallTimer timer_;
  ros::Subscriber subscriber_;
};

}  // namespace lamina
