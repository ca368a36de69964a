// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// How a joint moves the nozzle over the bed, seen with all joints at zero [mm, bed frame]. Joints that carry
/// the bed count against the nozzle: their directions are turned round.
struct Screw {
  Point3 direction = Point3::Zero();  ///< in which (linear) or about which (rotary); of unit length
  Point3 point = Point3::Zero();      ///< on the axis
};

/// A link as its parent carries it.
struct ChainLink {
  static constexpr int kNone = -1;

  std::string name;
  int parent = kNone;  ///< index of the link; none at the root
  Eigen::Isometry3d parent_from_link_at_zero = Eigen::Isometry3d::Identity();  ///< [mm]
  std::string moved_by;                                                        ///< joint of the URDF
  int joint = kNone;  ///< index of the driven joint it follows; none if it is fixed to its parent
  JointKind kind = JointKind::Linear;
  Point3 axis = Point3::Zero();  ///< [frame of the link]
  double factor = 1.0;           ///< 1 and 0, but for a joint that mimics the driven one
  double offset = 0.0;           ///< [mm, rad]
};

/// The joints between bed and nozzle, and the links that go with them.
struct SerialChain {
  std::string name;
  std::string urdf;                 ///< the text it was made from
  std::vector<DrivenJoint> joints;  ///< in the order of `serialChain`
  std::vector<Screw> screws;        ///< of the joints
  std::vector<int> outward;         ///< indices of the joints in their order from the bed to the nozzle
  Eigen::Isometry3d bed_from_nozzle_at_zero = Eigen::Isometry3d::Identity();  ///< [mm]
  std::vector<ChainLink> links;                                               ///< parents before children
};

/// Prismatic, revolute and continuous joints between the links bed and nozzle are the driven ones; elsewhere
/// only joints may move that mimic one of them. Those named external_... are the last, by name; before them,
/// if there is a joint x, linear ones before rotary ones and by name, else as they follow each other from the
/// bed. A continuous joint has infinite limits, and a linear one
/// whose range is 1 km or more has no upper one.
/// @throws InvalidConfig if a link bed or nozzle is missing, a driven joint has no limits or no speed or an
///   axis that is not of unit length, or a joint moves in another way; names it
SerialChain serialChain(const urdf::ModelInterface& model, const std::string& text);

/// @return [mm]
Eigen::Isometry3d bedFromNozzle(const SerialChain& chain, const JointValues& values);

Jacobian jacobian(const SerialChain& chain, const JointValues& values);

/// Where the nozzle is, and in which direction, or about which axis, each joint moves it.
struct NozzleAndJoints {
  Eigen::Isometry3d bed_from_nozzle;  ///< [mm]
  /// A column per joint, of unit length [bed frame].
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMostJoints> directions;
};
NozzleAndJoints nozzleAndJoints(const SerialChain& chain, const JointValues& values);

/// Every link [mm].
std::map<std::string, Eigen::Isometry3d> bedFromLinks(const SerialChain& chain, const JointValues& values);

/// Every joint of the URDF that moves [mm, rad].
std::map<std::string, double> urdfJoints(const SerialChain& chain, const JointValues& values);

}  // namespace lamina
