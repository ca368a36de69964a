// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tf/transform_intake.hpp"

#include <tf2/exceptions.h>

namespace lamina {
namespace {

constexpr std::uint32_t kNoBound = 0;  // of a queue

}  // namespace

TransformIntake::TransformIntake(tf2::BufferCore& buffer, const ros::NodeHandle& node)
    : TransformIntake(
          node,
          [&buffer](const auto& transform, const auto& authority) {
            buffer.setTransform(transform, authority, false);
          },
          [&buffer](const auto& transform, const auto& authority) {
            buffer.setTransform(transform, authority, true);
          }) {}

TransformIntake::TransformIntake(TransformSequence& sequence, const ros::NodeHandle& node)
    : TransformIntake(
          node,
          [&sequence](const auto& transform, const auto& authority) { sequence.add(transform, authority); },
          [&sequence](const auto& transform, const auto& authority) {
            sequence.addFixed(transform, authority);
          }) {}

TransformIntake::TransformIntake(const ros::NodeHandle& node, const Keeper& keep_moving,
                                 const Keeper& keep_fixed)
    : node_(node), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  moving_ = subscribe("/tf", keep_moving);
  static_ = subscribe("/tf_static", keep_fixed);
  spinner_.start();
}

ros::Subscriber TransformIntake::subscribe(const std::string& topic, const Keeper& keep) {
  const boost::function<void(const Event&)> onMessage = [keep](const Event& event) { store(event, keep); };
  return node_.subscribe<tf2_msgs::TFMessage>(topic, kNoBound, onMessage, {},
                                              ros::TransportHints().tcpNoDelay());
}

void TransformIntake::store(const Event& event, const Keeper& keep) {
  for (const auto& transform : event.getMessage()->transforms) {
    try {
      keep(transform, event.getPublisherName());
    } catch (const tf2::TransformException& error) {
      ROS_ERROR_THROTTLE(10.0, "transform from %s to %s ignored: %s", transform.header.frame_id.c_str(),
                         transform.child_frame_id.c_str(), error.what());
    }
  }
}

}  // namespace lamina
