// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/serial_chain.hpp"

namespace lamina {
namespace {

Eigen::Isometry3d motionOf(JointKind kind, const Point3& direction, double value) {
  if (kind == JointKind::Linear) return Eigen::Isometry3d(Eigen::Translation3d(value * direction));
  return Eigen::Isometry3d(Eigen::AngleAxisd(value, direction));
}

Eigen::Isometry3d motionOf(JointKind kind, const Screw& screw, double value) {
  if (kind == JointKind::Linear) return motionOf(kind, screw.direction, value);
  return Eigen::Translation3d(screw.point) * motionOf(kind, screw.direction, value) *
         Eigen::Translation3d(-screw.point);
}

double valueOf(const ChainLink& link, const JointValues& values) {
  return link.factor * values[link.joint] + link.offset;
}

}  // namespace

Eigen::Isometry3d bedFromNozzle(const SerialChain& chain, const JointValues& values) {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  for (const int j : chain.outward) {
    const auto index = static_cast<std::size_t>(j);
    moved = moved * motionOf(chain.joints[index].kind, chain.screws[index], values[j]);
  }
  return moved * chain.bed_from_nozzle_at_zero;
}

Jacobian jacobian(const SerialChain& chain, const JointValues& values) {
  const Point3 tip = bedFromNozzle(chain, values).translation();
  Jacobian columns = Jacobian::Zero(6, static_cast<Eigen::Index>(chain.joints.size()));
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  for (const int j : chain.outward) {
    const JointKind kind = chain.joints[static_cast<std::size_t>(j)].kind;
    const Screw& screw = chain.screws[static_cast<std::size_t>(j)];
    const Point3 direction = moved.linear() * screw.direction;
    if (kind == JointKind::Linear) {
      columns.col(j).head<3>() = direction;
    } else {
      columns.col(j).head<3>() = direction.cross(tip - moved * screw.point);
      columns.col(j).tail<3>() = direction;
    }
    moved = moved * motionOf(kind, screw, values[j]);
  }
  return columns;
}

std::map<std::string, Eigen::Isometry3d> bedFromLinks(const SerialChain& chain, const JointValues& values) {
  std::vector<Eigen::Isometry3d> root_from_links;
  Eigen::Isometry3d bed_from_root = Eigen::Isometry3d::Identity();
  for (const ChainLink& link : chain.links) {
    Eigen::Isometry3d root_from_link = link.parent_from_link_at_zero;
    if (link.parent != ChainLink::kNone)
      root_from_link = root_from_links[static_cast<std::size_t>(link.parent)] * root_from_link;
    if (link.joint != ChainLink::kNone)
      root_from_link = root_from_link * motionOf(link.kind, link.axis, valueOf(link, values));
    root_from_links.push_back(root_from_link);
    if (link.name == "bed") bed_from_root = root_from_link.inverse();
  }
  std::map<std::string, Eigen::Isometry3d> bed_from_links;
  for (std::size_t l = 0; l < root_from_links.size(); ++l)
    bed_from_links[chain.links[l].name] = bed_from_root * root_from_links[l];
  return bed_from_links;
}

std::map<std::string, double> urdfJoints(const SerialChain& chain, const JointValues& values) {
  std::map<std::string, double> all;
  for (const ChainLink& link : chain.links)
    if (link.joint != ChainLink::kNone) all[link.moved_by] = valueOf(link, values);
  return all;
}

}  // namespace lamina
