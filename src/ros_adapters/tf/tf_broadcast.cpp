// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tf/tf_broadcast.hpp"

#include <tf2_msgs/TFMessage.h>

#include <cstdint>

#include "conversions.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kUnbounded = 0;  // of a queue: between poses tf goes straight, so none may be lost

geometry_msgs::TransformStamped frame(const std::string& parent, const std::string& child,
                                      const geometry_msgs::Pose& pose) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation.x = pose.position.x;
  message.transform.translation.y = pose.position.y;
  message.transform.translation.z = pose.position.z;
  message.transform.rotation = pose.orientation;
  return message;
}

}  // namespace

TfBroadcast::TfBroadcast(ros::NodeHandle& node, const std::string& urdf, LastPositions last)
    : machine_(urdf) {
  auto fixed = machine_.fixed(ros::Time::now());
  if (machine_.rootLink() != names::kWorldFrame)
    fixed.push_back(frame(names::kWorldFrame, machine_.rootLink(), toMessage(Eigen::Isometry3d::Identity())));
  fixed_.sendTransform(fixed);
  moving_ = node.advertise<tf2_msgs::TFMessage>("/tf", kUnbounded, last == LastPositions::Kept);
}

void TfBroadcast::sendPart(const geometry_msgs::Pose& bed_from_part) {
  fixed_.sendTransform(frame(names::kBedFrame, names::kPartFrame, bed_from_part));
}

void TfBroadcast::sendLinks(const JointPositions& positions, const ros::Time& stamp) const {
  tf2_msgs::TFMessage transforms;
  transforms.transforms = machine_.moving(positions, stamp);
  moving_.publish(transforms);
}

}  // namespace lamina
