// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/serial_chain.hpp"

namespace lamina {
namespace {

Eigen::Isometry3d motionOf(JointKind kind, const Point3& direction, double value) {
  if (kind == JointKind::Linear) return Eigen::Isometry3d(Eigen::Translation3d(value * direction));
  return Eigen::Isometry3d(Eigen::AngleAxisd(value, direction));
}

/// What joints make of points and directions of the bed that they carry: planning asks for it millions of
/// times, and most joints either turn or shift alone.
struct Carried {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Point3 shift = Point3::Zero();

  void carry(JointKind kind, const Screw& screw, double value) {
    if (kind == JointKind::Linear) {
      shift += turn * (value * screw.direction);
    } else if (value != 0.0) {
      const Eigen::Matrix3d further = Eigen::AngleAxisd(value, screw.direction).toRotationMatrix();
      shift += turn * (screw.point - further * screw.point);
      turn = turn * further;
    }
  }
};

/// Goes from the bed to the nozzle.
/// @param visit  (joint, what those before it make of the bed)
template <class Visit>
Carried carriedOutward(const SerialChain& chain, const JointValues& values, const Visit& visit) {
  Carried carried;
  for (const int j : chain.outward) {
    visit(j, carried);
    const auto index = static_cast<std::size_t>(j);
    carried.carry(chain.joints[index].kind, chain.screws[index], values[j]);
  }
  return carried;
}

Eigen::Isometry3d nozzleOf(const Carried& carried, const SerialChain& chain) {
  Eigen::Isometry3d bed_from_nozzle = Eigen::Isometry3d::Identity();
  bed_from_nozzle.linear().noalias() = carried.turn * chain.bed_from_nozzle_at_zero.linear();
  bed_from_nozzle.translation() = carried.turn * chain.bed_from_nozzle_at_zero.translation() + carried.shift;
  return bed_from_nozzle;
}

double valueOf(const ChainLink& link, const JointValues& values) {
  return link.factor * values[link.joint] + link.offset;
}

}  // namespace

Eigen::Isometry3d bedFromNozzle(const SerialChain& chain, const JointValues& values) {
  return nozzleOf(carriedOutward(chain, values, [](int, const Carried&) {}), chain);
}

NozzleAndJoints nozzleAndJoints(const SerialChain& chain, const JointValues& values) {
  NozzleAndJoints found;
  found.directions.resize(3, static_cast<Eigen::Index>(chain.joints.size()));
  const Carried carried = carriedOutward(chain, values, [&](int j, const Carried& before) {
    found.directions.col(j) = before.turn * chain.screws[static_cast<std::size_t>(j)].direction;
  });
  found.bed_from_nozzle = nozzleOf(carried, chain);
  return found;
}

Jacobian jacobian(const SerialChain& chain, const JointValues& values) {
  const Point3 tip = bedFromNozzle(chain, values).translation();
  Jacobian columns = Jacobian::Zero(6, static_cast<Eigen::Index>(chain.joints.size()));
  carriedOutward(chain, values, [&](int j, const Carried& before) {
    const Screw& screw = chain.screws[static_cast<std::size_t>(j)];
    const Point3 direction = before.turn * screw.direction;
    if (chain.joints[static_cast<std::size_t>(j)].kind == JointKind::Linear) {
      columns.col(j).head<3>() = direction;
    } else {
      columns.col(j).head<3>() = direction.cross(tip - (before.turn * screw.point + before.shift));
      columns.col(j).tail<3>() = direction;
    }
  });
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
