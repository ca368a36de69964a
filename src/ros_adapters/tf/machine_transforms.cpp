// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tf/machine_transforms.hpp"

#include <cmath>
#include <kdl_parser/kdl_parser.hpp>

#include "conversions.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

geometry_msgs::TransformStamped transform(const std::string& parent, const KDL::Segment& segment,
                                          double position, const ros::Time& stamp) {
  const KDL::Frame frame = segment.pose(position);
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = segment.getName();
  message.transform.translation.x = frame.p.x();
  message.transform.translation.y = frame.p.y();
  message.transform.translation.z = frame.p.z();
  auto& rotation = message.transform.rotation;
  frame.M.GetQuaternion(rotation.x, rotation.y, rotation.z, rotation.w);
  return message;
}

double positionOf(const KDL::Segment& segment, const JointPositions& positions) {
  const std::string& joint = segment.getJoint().getName();
  const auto found = positions.find(joint);
  if (found == positions.end() || !std::isfinite(found->second))
    throw InvalidInput("no position of axis '" + joint + "'; each report must hold all axes");
  return found->second;
}

}  // namespace

MachineTransforms::MachineTransforms(const std::string& urdf) {
  KDL::Tree tree;
  if (!kdl_parser::treeFromString(urdf, tree)) throw InvalidConfig("the machine's description is no URDF");
  root_ = tree.getRootSegment()->first;
  for (const auto& entry : tree.getSegments()) {
    if (entry.first == root_) continue;
    const KDL::Segment& segment = entry.second.segment;
    const bool is_fixed = segment.getJoint().getType() == KDL::Joint::None;
    (is_fixed ? fixed_ : moving_).push_back({entry.second.parent->first, segment});
  }
}

JointPositions MachineTransforms::positions(const std::map<std::string, double>& values) const {
  JointPositions positions;
  for (const Link& link : moving_) {
    const KDL::Joint& joint = link.segment.getJoint();
    const auto value = values.find(joint.getName());
    if (value == values.end()) continue;
    const bool is_linear = joint.getType() == KDL::Joint::TransAxis ||
                           joint.getType() == KDL::Joint::TransX || joint.getType() == KDL::Joint::TransY ||
                           joint.getType() == KDL::Joint::TransZ;
    positions[joint.getName()] = is_linear ? toMetres(value->second) : value->second;
  }
  return positions;
}

std::vector<geometry_msgs::TransformStamped> MachineTransforms::fixed(const ros::Time& stamp) const {
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const Link& link : fixed_) transforms.push_back(transform(link.parent, link.segment, 0.0, stamp));
  return transforms;
}

std::vector<geometry_msgs::TransformStamped> MachineTransforms::moving(const JointPositions& positions,
                                                                       const ros::Time& stamp) const {
  std::vector<geometry_msgs::TransformStamped> transforms;
  transforms.reserve(moving_.size());
  for (const Link& link : moving_)
    transforms.push_back(transform(link.parent, link.segment, positionOf(link.segment, positions), stamp));
  return transforms;
}

}  // namespace lamina
