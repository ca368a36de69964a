// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/link_tree.hpp"

#include "kinematics/model/link_motion.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

bool isRotaryJoint(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
}

}  // namespace

LinkTree::LinkTree(const urdf::ModelInterface& model) {
  std::vector<const urdf::Link*> links = {model.getRoot().get()};
  nodes_.emplace_back();
  nodes_[0].name = links[0]->name;
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const auto& child : links[i]->child_links) {
      const urdf::Joint& joint = *child->parent_joint;
      Node node;
      node.name = child->name;
      node.parent = i;
      node.parent_from_link_at_zero = poseOf(joint.parent_to_joint_origin_transform);
      node.is_linear = joint.type == urdf::Joint::PRISMATIC;
      if (node.is_linear || isRotaryJoint(joint)) {
        node.joint = joint.name;
        node.axis = directionOf(model, joint);
      } else if (joint.type != urdf::Joint::FIXED) {
        throw InvalidConfig("machine '" + model.getName() + "': joint '" + joint.name +
                            "' is neither fixed, prismatic, revolute nor continuous");
      }
      links.push_back(child.get());
      nodes_.push_back(std::move(node));
    }
  }
}

std::map<std::string, Eigen::Isometry3d> LinkTree::rootFromLinks(
    const std::map<std::string, double>& joints) const {
  std::vector<Eigen::Isometry3d> poses;
  std::map<std::string, Eigen::Isometry3d> by_name;
  for (const Node& node : nodes_) {
    Eigen::Isometry3d pose = node.parent_from_link_at_zero;
    if (!poses.empty()) pose = poses[node.parent] * pose;
    const auto value = joints.find(node.joint);
    if (value != joints.end() && node.is_linear) pose.translate(value->second * node.axis);
    if (value != joints.end() && !node.is_linear) pose.rotate(Eigen::AngleAxisd(value->second, node.axis));
    poses.push_back(pose);
    by_name[node.name] = pose;
  }
  return by_name;
}

}  // namespace lamina
