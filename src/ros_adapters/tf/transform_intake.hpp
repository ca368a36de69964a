// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <string>

#include "tf/transform_sequence.hpp"

namespace lamina {

/// Feeds a buffer or a sequence from tf as long as it exists, in a thread of its own.
/// tf2_ros::TransformListener does this too, but its queue of 100 messages loses transforms if a machine in
/// accelerated time reports thousands a second, and a pose interpolated over such a gap is wrong by the size
/// of a corner. Here nothing is lost: the queue is not bounded, and transforms are only stored.
class TransformIntake {
 public:
  /// @param buffer  must outlive the object
  TransformIntake(tf2::BufferCore& buffer, const ros::NodeHandle& node);
  /// @param sequence  must outlive the object
  TransformIntake(TransformSequence& sequence, const ros::NodeHandle& node);

  /// Whether any node publishes moving transforms.
  bool isConnected() const { return moving_.getNumPublishers() > 0; }

 private:
  using Event = ros::MessageEvent<tf2_msgs::TFMessage const>;
  using Keeper = std::function<void(const geometry_msgs::TransformStamped&, const std::string& authority)>;

  TransformIntake(const ros::NodeHandle& node, const Keeper& keep_moving, const Keeper& keep_fixed);

  ros::Subscriber subscribe(const std::string& topic, const Keeper& keep);
  static void store(const Event& event, const Keeper& keep);

  ros::NodeHandle node_;
  ros::CallbackQueue queue_;
  ros::Subscriber moving_;
  ros::Subscriber static_;
  ros::AsyncSpinner spinner_;
};

}  // namespace lamina
