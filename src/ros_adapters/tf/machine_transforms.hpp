// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>

#include <kdl/tree.hpp>
#include <map>
#include <string>
#include <vector>

namespace lamina {

/// Axis positions by joint name [m, rad].
using JointPositions = std::map<std::string, double>;

/// The transforms between a machine's links. robot_state_publisher computes the same, but its queue of 100
/// transforms loses some where a machine reports thousands a second.
class MachineTransforms {
 public:
  /// @throws InvalidConfig if it is no URDF
  explicit MachineTransforms(const std::string& urdf);

  const std::string& rootLink() const { return root_; }
  /// Values of joints in SI; joints that move no link stay behind.
  /// @param values  by name [mm, rad] (`KinematicModel::urdfJoints`)
  JointPositions positions(const std::map<std::string, double>& values) const;
  /// Of the links that never move against their parents.
  std::vector<geometry_msgs::TransformStamped> fixed(const ros::Time& stamp) const;
  /// Of the links that do.
  /// @throws InvalidInput if a joint has no position or one that is not finite
  std::vector<geometry_msgs::TransformStamped> moving(const JointPositions& positions,
                                                      const ros::Time& stamp) const;

 private:
  struct Link {
    std::string parent;
    KDL::Segment segment;
  };

  std::string root_;
  std::vector<Link> fixed_;
  std::vector<Link> moving_;
};

}  // namespace lamina
