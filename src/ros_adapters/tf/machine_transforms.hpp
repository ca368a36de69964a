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

/// Computes the transforms between a machine's links. robot_state_publisher does this too, but its queue of
/// 100 transforms loses some if a machine reports thousands a second.
class MachineTransforms {
 public:
  /// @throws InvalidConfig if the text is no URDF
  explicit MachineTransforms(const std::string& urdf);

  const std::string& rootLink() const { return root_; }
  /// Converts joint values to SI units; joints that move no link are left out.
  /// @param values  by name [mm, rad] (`KinematicModel::urdfJoints`)
  JointPositions positions(const std::map<std::string, double>& values) const;
  /// Transforms of the links that never move relative to their parents.
  std::vector<geometry_msgs::TransformStamped> fixed(const ros::Time& stamp) const;
  /// Transforms of all other links.
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
