// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description_files/flange.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/decimals.hpp"
#include "kinematics/model/link_motion.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

/// The links on which none hangs.
std::vector<std::string> endsOf(const urdf::ModelInterface& model) {
  std::vector<std::string> ends;
  for (const auto& [name, link] : model.links_)
    if (link->child_links.empty()) ends.push_back("'" + name + "'");
  return ends;
}

/// As a cell file takes it, without decimals that are rounding alone.
std::string anglesText(double pitch, double yaw) {
  const auto degrees = [](double angle) {
    const double rounded = std::round(toDegrees(angle) * 1e3) * 1e-3;
    return trimmedDecimals(rounded, 3);
  };
  return "[0, " + degrees(pitch) + ", " + degrees(yaw) + "]";
}

}  // namespace

std::string flangeTurns(const Eigen::Vector3d& axis) {
  const double pitch = std::acos(std::clamp(axis.z(), -1.0, 1.0));
  const double yaw = std::atan2(axis.y(), axis.x());
  return anglesText(pitch, yaw) + " along it, or " + anglesText(pitch - M_PI, yaw) + " against it";
}

std::string flangeOf(const urdf::ModelInterface& model, const std::string& named) {
  for (const std::string& name : {named, std::string("tool0"), std::string("flange")}) {
    if (name.empty()) continue;
    if (model.getLink(name)) return name;
    if (name == named)
      throw InvalidConfig("arm '" + model.getName() + "' has no link '" + name +
                          "' (flange); expected one of " + listed(endsOf(model)) +
                          ", or another of its links");
  }
  std::string tip;
  int most = -1;
  for (const auto& [name, link] : model.links_) {
    int moving = 0;
    for (urdf::LinkConstSharedPtr up = link; up && up->parent_joint;
         up = model.getLink(up->parent_joint->parent_link_name))
      moving += up->parent_joint->type != urdf::Joint::FIXED && !up->parent_joint->mimic ? 1 : 0;
    if (moving > most || (moving == most && link->child_links.empty())) tip = name;
    most = std::max(most, moving);
  }
  return tip;
}

Eigen::Vector3d flangeAxis(const urdf::ModelInterface& model, const std::string& flange) {
  Eigen::Isometry3d last_from_flange = Eigen::Isometry3d::Identity();
  for (const urdf::Link* link = &requireLink(model, flange); link->parent_joint;
       link = &requireLink(model, link->parent_joint->parent_link_name)) {
    const urdf::Joint& joint = *link->parent_joint;
    if (joint.type != urdf::Joint::FIXED)
      return last_from_flange.linear().transpose() * directionOf(model, joint);
    last_from_flange = poseOf(joint.parent_to_joint_origin_transform) * last_from_flange;
  }
  throw InvalidConfig("arm '" + model.getName() + "': nothing moves link '" + flange +
                      "'; expected a flange");
}

}  // namespace lamina
