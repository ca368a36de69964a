// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "transform_intake.hpp"

#include <tf2/exceptions.h>

namespace lamina {
namespace {

constexpr std::uint32_t kBurst = 20000;  // messages: what a machine in accelerated time sends in some seconds

}  // namespace

TransformIntake::TransformIntake(tf2::BufferCore& buffer, const ros::NodeHandle& node)
    : buffer_(buffer), node_(node), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  moving_ = subscribe("/tf", false);
  static_ = subscribe("/tf_static", true);
  spinner_.start();
}

ros::Subscriber TransformIntake::subscribe(const std::string& topic, bool is_static) {
  const boost::function<void(const Event&)> onMessage = [this, is_static](const Event& event) {
    store(event, is_static);
  };
  return node_.subscribe<tf2_msgs::TFMessage>(topic, kBurst, onMessage, {},
                                              ros::TransportHints().tcpNoDelay());
}

void TransformIntake::store(const Event& event, bool is_static) {
  for (const auto& transform : event.getMessage()->transforms) {
    try {
      buffer_.setTransform(transform, event.getPublisherName(), is_static);
    } catch (const tf2::TransformException& error) {
      ROS_ERROR_THROTTLE(10.0, "transform from %s to %s ignored: %s", transform.header.frame_id.c_str(),
                         transform.child_frame_id.c_str(), error.what());
    }
  }
}

}  // namespace lamina
