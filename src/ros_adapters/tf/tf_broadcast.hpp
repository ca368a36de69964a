// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <string>

#include "tf/machine_transforms.hpp"

namespace lamina {

/// Sends the frames of a machine and of the part on its bed to tf.
class TfBroadcast {
 public:
  /// Whether a later listener receives the last positions of the moving links. A machine at rest reports
  /// nothing more; a toolpath that is played is repeated in time.
  enum class LastPositions { Dropped, Kept };

  /// Sends the links that never move, and the frame `world` as the parent of the machine's root.
  /// @throws InvalidConfig if it is no URDF
  TfBroadcast(ros::NodeHandle& node, const std::string& urdf, LastPositions last);

  const MachineTransforms& machine() const { return machine_; }
  /// Sends the frame `part` as a child of `bed`.
  void sendPart(const geometry_msgs::Pose& bed_from_part);
  /// Sends the links that move.
  /// @throws InvalidInput if a joint has no position or one that is not finite
  void sendLinks(const JointPositions& positions, const ros::Time& stamp) const;

 private:
  MachineTransforms machine_;
  tf2_ros::StaticTransformBroadcaster fixed_;
  ros::Publisher moving_;
};

}  // namespace lamina
