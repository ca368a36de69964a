// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <urdf_parser/urdf_parser.h>

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "support/arms.hpp"

namespace lamina {
namespace {

KDL::Frame frameOf(const urdf::Pose& pose) {
  const urdf::Rotation& r = pose.rotation;
  return {KDL::Rotation::Quaternion(r.x, r.y, r.z, r.w),
          KDL::Vector(pose.position.x, pose.position.y, pose.position.z)};
}

KDL::Joint jointOf(const urdf::Joint& joint, const KDL::Frame& parent_from_joint) {
  if (joint.type == urdf::Joint::FIXED) return KDL::Joint(joint.name, KDL::Joint::None);
  const KDL::Vector axis(joint.axis.x, joint.axis.y, joint.axis.z);
  return {joint.name, parent_from_joint.p, parent_from_joint.M * axis, KDL::Joint::RotAxis};
}

/// From the root of the description to a link.
KDL::Chain chainTo(const urdf::ModelInterface& model, const std::string& link) {
  std::vector<KDL::Segment> segments;
  for (auto at = model.getLink(link); at->parent_joint; at = at->getParent()) {
    const KDL::Frame placed = frameOf(at->parent_joint->parent_to_joint_origin_transform);
    segments.emplace_back(at->name, jointOf(*at->parent_joint, placed), placed);
  }
  KDL::Chain chain;
  for (auto segment = segments.rbegin(); segment != segments.rend(); ++segment) chain.addSegment(*segment);
  return chain;
}

/// The first of the values, those of a chain's joints.
KDL::JntArray jointsOf(const KDL::Chain& chain, const JointValues& values) {
  KDL::JntArray joints(chain.getNrOfJoints());
  joints.data = values.head(chain.getNrOfJoints());
  return joints;
}

Eigen::Isometry3d poseOf(const KDL::Frame& frame) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    pose.translation()[row] = 1e3 * frame.p[row];
    for (int column = 0; column < 3; ++column) pose.linear()(row, column) = frame.M(row, column);
  }
  return pose;
}

Eigen::Isometry3d kdlComparisonForward(const KDL::Chain& chain, const JointValues& values) {
  KDL::Frame frame;
  KDL::ChainFkSolverPos_recursive(chain).JntToCart(jointsOf(chain, values), frame);
  return poseOf(frame);
}

TEST(KdlComparison, TheNozzleIsWhereKdlPutsIt) {
  const std::vector<std::string> descriptions = {kinematicModelByName("irb_4400")->urdf(),
                                                 kinematicModelByName("irb_4600")->urdf(),
                                                 test::roundedArm().urdf(), test::parallelAxesArm().urdf()};
  for (const std::string& urdf : descriptions) {
    const auto arm = kinematicModelFromUrdf(urdf);
    const auto model = urdf::parseURDF(urdf);
    const KDL::Chain to_nozzle = chainTo(*model, "nozzle");
    const Eigen::Isometry3d root_from_bed =
        kdlComparisonForward(chainTo(*model, "bed"), JointValues::Zero(6));
    EXPECT_TRUE(rc::check([&](std::uint64_t seed) {
      Random random(seed);
      const JointValues values = test::anyJointValues(*arm, random);
      const Eigen::Isometry3d expected = root_from_bed.inverse() * kdlComparisonForward(to_nozzle, values);
      RC_ASSERT(test::distance(arm->bedFromNozzle(values), expected) < 1e-12);
    }));
  }
}

TEST(KdlComparison, TheJacobianIsThatOfKdl) {
  const auto arm = kinematicModelByName("irb_4600");
  const auto model = urdf::parseURDF(arm->urdf());
  const KDL::Chain chain = chainTo(*model, "nozzle");
  // The bed stands as the base does: both see the same directions.
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const JointValues values = test::anyJointValues(*arm, random);
    KDL::Jacobian expected(6);
    KDL::ChainJntToJacSolver(chain).JntToJac(jointsOf(chain, values), expected);
    Jacobian jacobian = arm->jacobian(values);
    jacobian.topRows<3>() *= 1e-3;
    EXPECT_LT((jacobian - expected.data).cwiseAbs().maxCoeff(), 1e-12);
  }
}

}  // namespace
}  // namespace lamina
