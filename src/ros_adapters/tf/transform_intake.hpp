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

/// Feeds a buffer or a sequence from tf while it lives, on a thread of its own. tf2_ros::TransformListener
/// does the same, but its queue of 100 messages loses transforms where a machine in accelerated time reports
/// thousands a second; a pose interpolated over the gap is wrong by the width of a corner. Here nothing is
/// lost: the queue has no bound, and what is received is only stored.
class TransformIntake {
 public:
  /// @param buffer  must outlive this
  TransformIntake(tf2::BufferCore& buffer, const ros::NodeHandle& node);
  /// @param sequence  must outlive this
  TransformIntake(TransformSequence& sequence, const ros::NodeHandle& node);

  /// Whether somebody publishes transforms that move.
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
