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

/// Axis along or about which a joint moves the nozzle relative to the bed, with all joints at zero [mm, bed
/// frame]. Directions of joints that carry the bed are reversed.
struct Screw {
  /// Along which (linear) or about which (rotary) the nozzle moves; of unit length.
  Point3 direction = Point3::Zero();
  Point3 point = Point3::Zero();  ///< a point of the axis
};

/// A link, and how its parent carries it.
struct ChainLink {
  static constexpr int kNone = -1;

  std::string name;
  int parent = kNone;  ///< index of the parent link; none at the root
  Eigen::Isometry3d parent_from_link_at_zero = Eigen::Isometry3d::Identity();  ///< [mm]
  std::string moved_by;                                                        ///< joint of the URDF
  int joint = kNone;  ///< index of the driven joint that moves the link; none if it is fixed to its parent
  JointKind kind = JointKind::Linear;
  Point3 axis = Point3::Zero();  ///< [frame of the link]
  /// Factor on the driven joint's value; 1, with offset 0, unless the link's joint mimics the driven one.
  double factor = 1.0;
  double offset = 0.0;  ///< added to that product [mm, rad]
};

/// The joints between bed and nozzle, and all links.
struct SerialChain {
  std::string name;
  std::string urdf;                 ///< the URDF from which the chain was made
  std::vector<DrivenJoint> joints;  ///< in the order of `serialChain`
  std::vector<Screw> screws;        ///< axis of each joint
  std::vector<int> outward;         ///< indices of the joints from the bed to the nozzle
  Eigen::Isometry3d bed_from_nozzle_at_zero = Eigen::Isometry3d::Identity();  ///< [mm]
  std::vector<ChainLink> links;                                               ///< parents before children
};

/// Makes the chain of a URDF. Its driven joints are the prismatic, revolute and continuous ones between the
/// links bed and nozzle; elsewhere, only joints that mimic one of them may move. Joints not named
/// external_... come first, then joints named external_..., by name. If there is a joint x, the first group
/// is sorted with linear joints before rotary ones and by name; otherwise it keeps the order from the bed. A
/// continuous joint has infinite limits. A linear one whose range is 1 km or more has no upper limit.
/// @throws InvalidConfig naming the link or joint: a link bed or nozzle is missing, a driven joint has no
///   limits, no speed, or an axis that is not of unit length, or another joint moves
SerialChain serialChain(const urdf::ModelInterface& model, const std::string& text);

/// Pose of the nozzle over the bed [mm].
Eigen::Isometry3d bedFromNozzle(const SerialChain& chain, const JointValues& values);

Jacobian jacobian(const SerialChain& chain, const JointValues& values);

/// Pose of the nozzle, and for each joint the direction along or about which it moves the nozzle.
struct NozzleAndJoints {
  Eigen::Isometry3d bed_from_nozzle;  ///< [mm]
  /// One column for each joint, of unit length [bed frame].
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMostJoints> directions;
};
NozzleAndJoints nozzleAndJoints(const SerialChain& chain, const JointValues& values);

/// Poses of all links over the bed, by name [mm].
std::map<std::string, Eigen::Isometry3d> bedFromLinks(const SerialChain& chain, const JointValues& values);

/// Values of all joints of the URDF that move, by name [mm, rad].
std::map<std::string, double> urdfJoints(const SerialChain& chain, const JointValues& values);

}  // namespace lamina
