// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <rosbag/bag.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "names.hpp"
#include "tf/transform_lookup.hpp"

namespace lamina::test {

constexpr double kSameTip = 1e-3;       ///< how far a tip of tf may be from that of its waypoint [mm]: 1e-6 m
constexpr double kSameToolAxis = 1e-6;  ///< and a tool axis [rad]

/// Everything said on tf and tf_static of a namespace.
class TfRecording {
 public:
  explicit TfRecording(const std::string& space) : node_(space), buffer_(ros::Duration(3600.0)) {
    const boost::function<void(const tf2_msgs::TFMessageConstPtr&)> on_tf = [this](const auto& message) {
      keep(*message, false);
    };
    const boost::function<void(const tf2_msgs::TFMessageConstPtr&)> on_static = [this](const auto& message) {
      keep(*message, true);
    };
    tf_ = node_.subscribe<tf2_msgs::TFMessage>("tf", 100000, on_tf);
    tf_static_ = node_.subscribe<tf2_msgs::TFMessage>("tf_static", 100, on_static);
  }

  bool isConnected() const { return tf_.getNumPublishers() > 0 && tf_static_.getNumPublishers() > 0; }

  /// bed_from_nozzle at each stamp, in order of time [mm].
  std::vector<Eigen::Isometry3d> nozzles() const {
    std::vector<Eigen::Isometry3d> found;
    for (const ros::Time& stamp : stamps_)
      if (const auto pose = lookUp(buffer_, names::kBedFrame, names::kNozzleFrame, stamp))
        found.push_back(*pose);
    return found;
  }
  /// bed_from_nozzle at the latest stamp [mm]; none before the first.
  std::optional<Eigen::Isometry3d> lastNozzle() const {
    if (stamps_.empty()) return std::nullopt;
    return lookUp(buffer_, names::kBedFrame, names::kNozzleFrame, *stamps_.rbegin());
  }
  /// Whether the nozzle tip is there at last, within a micrometre.
  bool isAt(const Point3& tip) const {
    const auto pose = lastNozzle();
    return pose && (pose->translation() - tip).norm() < kSameTip;
  }

  void write(rosbag::Bag& bag) const {
    for (const auto& [topic, stamp, message] : messages_) bag.write(node_.resolveName(topic), stamp, message);
  }

 private:
  struct Received {
    std::string topic;
    ros::Time stamp;
    tf2_msgs::TFMessage message;
  };

  void keep(const tf2_msgs::TFMessage& message, bool is_static) {
    messages_.push_back({is_static ? "tf_static" : "tf", ros::Time::now(), message});
    for (const auto& transform : message.transforms) {
      buffer_.setTransform(transform, "test", is_static);
      if (!is_static) stamps_.insert(transform.header.stamp);
    }
  }

  ros::NodeHandle node_;
  tf2::BufferCore buffer_;
  std::set<ros::Time> stamps_;
  std::vector<Received> messages_;
  ros::Subscriber tf_, tf_static_;
};

}  // namespace lamina::test
