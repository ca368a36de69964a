// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/robot_cell.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/angle.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"
#include "support/arms.hpp"

namespace lamina {
namespace {

JointValues jointsOf(const KinematicModel& arm, const std::array<double, 6>& degrees) {
  SixJoints six;
  for (std::size_t j = 0; j < 6; ++j) six[static_cast<Eigen::Index>(j)] = toRadians(degrees[j]);
  return withSixJoints(arm, JointValues::Zero(static_cast<Eigen::Index>(arm.joints().size())), six);
}

void expectDegrees(const ControllerJoints& joints, const std::array<double, 6>& expected) {
  for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR(joints.arm_deg[j], expected[j], 1e-9) << j;
}

TEST(RobotCell, JointsAreThoseThatAControllerCounts) {
  const auto arm = kinematicModelByName("irb_4600");
  const JointValues values = jointsOf(*arm, {10, -20, 30, -40, 50, -60});
  expectDegrees(controllerJoints({}, *arm, values), {10, -20, 30, -40, 50, -60});
  // A controller that counts joint 3 from level: J3 = joint_3 - joint_2.
  ControllerMap level;
  level.joint_3_from_2 = -1.0;
  expectDegrees(controllerJoints(level, *arm, values), {10, -20, 50, -40, 50, -60});
}

// A1 = -q1, A2 = q2 - 90, A3 = q3 + 90 make limits of -45..85 and -210..65 those of the maker, -135..-5 and
// -120..155.
TEST(RobotCell, MapsLimitsOfADescriptionToThoseOfItsController) {
  const auto arm = kinematicModelByName("irb_4600");
  ControllerMap map;
  map.signs = {-1, 1, 1, 1, 1, 1};
  map.zeros_deg = {0, -90, 90, 0, 0, 0};
  expectDegrees(controllerJoints(map, *arm, jointsOf(*arm, {185, -45, -210, 0, 0, 0})),
                {-185, -135, -120, 0, 0, 0});
  expectDegrees(controllerJoints(map, *arm, jointsOf(*arm, {-185, 85, 65, 0, 0, 0})),
                {185, -5, 155, 0, 0, 0});
}

TEST(RobotCell, JointsOfAControllerGiveThoseOfTheArmBack) {
  const auto arm = kinematicModelByName("irb_4600_turntable");
  EXPECT_TRUE(rc::check([&arm](std::uint64_t seed) {
    Random random(seed);
    const JointValues values = test::anyJointValues(*arm, random);
    ControllerMap map;
    for (double& sign : map.signs) sign = random.below(2) == 0 ? 1.0 : -1.0;
    for (double& zero : map.zeros_deg) zero = random.uniform(-180.0, 180.0);
    map.joint_3_from_2 = random.uniform(-1.0, 1.0);
    RC_ASSERT((armJoints(map, *arm, controllerJoints(map, *arm, values)) - values).cwiseAbs().maxCoeff() <
              1e-9);
  }));
}

TEST(RobotCell, CountsFromTheLinkBaseWhereTheDescriptionHasOne) {
  const auto plain = kinematicModelByName("irb_4600");
  EXPECT_TRUE(controllerCell(*plain).carrier_from_bed.isApprox(armCell(*plain).carrier_from_bed, 1e-12));
  // A base 525 mm above the root, as of an M-20iA: the bed is as much lower over it.
  std::string urdf = plain->urdf();
  const std::string root = "base_link";
  ASSERT_NE(urdf.find("<link name=\"" + root + "\""), std::string::npos);
  urdf.insert(urdf.rfind("</robot>"), test::fixedJoint("base", root, "xyz=\"0 0 0.525\""));
  const auto raised = kinematicModelFromUrdf(urdf);
  const Point3 off = armCell(*raised).carrier_from_bed.translation() -
                     controllerCell(*raised).carrier_from_bed.translation();
  EXPECT_TRUE(off.isApprox(Point3(0, 0, 525), 1e-6)) << off.transpose();
}

}  // namespace
}  // namespace lamina
