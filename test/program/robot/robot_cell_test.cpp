// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/robot_cell.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "lamina/program/rapid/reader/rapid_reader.hpp"
#include "lamina/program/rapid/writer/rapid_writer.hpp"
#include "lamina/program/robot/robot_motion.hpp"
#include "lamina/program/robot/robot_reader.hpp"
#include "lamina/program/robot/robot_writer.hpp"
#include "support/arms.hpp"
#include "support/toolpaths.hpp"

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

/// The map of a kr210l150, as its cell states it, in place of the settings that do.
TEST(RobotCell, ControllersOfTheCellMapItsProgram) {
  NoProgress nobody;
  const auto plain = kinematicModelByName("irb_4600");
  std::string urdf = plain->urdf();
  urdf.insert(urdf.rfind("</robot>"),
              "<lamina_controller kind=\"kuka\" sign=\"-1 1 1 1 1 1\" zero_deg=\"0 -90 90 0 0 0\" "
              "tool_number=\"3\"/>");
  const auto arm = kinematicModelFromUrdf(urdf);
  const Toolpath toolpath = test::twoLayers();
  const Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  const JointPath joints = planJointPath(toolpath, place, *arm, {}, nobody);
  const RobotMotion robot{*arm, joints};
  RobotProgramSettings mapped;
  mapped.joint_signs = {-1, 1, 1, 1, 1, 1};
  mapped.joint_zeros_deg = {0, -90, 90, 0, 0, 0};
  mapped.tool_number = 3;
  const RobotMotion without{*plain, joints};
  const auto expected = robotProgram(toolpath, place, {RobotLanguage::Krl, "part", mapped}, &without);
  const auto files = robotProgram(toolpath, place, {RobotLanguage::Krl, "part", {}}, &robot);
  EXPECT_EQ(files[0].text, expected[0].text);
  const auto refusal = [&](RobotLanguage language, const RobotProgramSettings& settings) -> std::string {
    try {
      robotProgram(toolpath, place, {language, "part", settings}, &robot);
      return "";
    } catch (const InvalidConfig& error) {
      return error.what();
    }
  };
  mapped.tool_number = 4;
  EXPECT_NE(refusal(RobotLanguage::Krl, mapped).find("robot_program.tool_number differs"), std::string::npos);
  EXPECT_NE(refusal(RobotLanguage::Fanuc, {}).find("cell.controller has the kind 'kuka'"), std::string::npos);
  EXPECT_THROW(RapidProgram(toolpath, place, {}, &robot), InvalidConfig);
  // A program of before the cell stated it would turn the arm the other way.
  EXPECT_NO_THROW(readRobotMotion(files, "part", *arm));
  const auto unmapped = robotProgram(toolpath, place, {RobotLanguage::Krl, "part", {}}, &without);
  EXPECT_THROW(readRobotMotion(unmapped, "part", *arm), InvalidProgram);
  const auto of_fanuc = robotProgram(toolpath, place, {RobotLanguage::Fanuc, "part", {}}, &without);
  EXPECT_THROW(readRobotMotion(of_fanuc, "part", *arm), InvalidConfig);
}

/// One bead askew under an arm on a gantry, led by both axes.
class RobotGantry : public testing::Test {
 protected:
  RobotGantry() : arm_(kinematicModelFromUrdf(test::gantryArm())) {
    Path path;
    path.role = PathRole::OuterWall;
    path.bead = Bead{6.0, 2.0};
    path.feed_mm_s = 50.0;
    path.orientation = Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0);
    for (int i = 0; i <= 40; ++i) path.points.emplace_back(75.0 * i, 60.0 * i, 2.0);
    toolpath_.layers.push_back({2.0, 2.0, {path}});
    JointPathSettings settings;
    settings.rail = RailChoice::Follow;
    settings.yaw = YawChoice::Held;  // targets state that of the toolpath
    NoProgress nobody;
    joints_ = planJointPath(toolpath_, place_, *arm_, settings, nobody);
  }

  void expectSame(const StatedMotion& motion, const std::string& what) const {
    ASSERT_EQ(motion.joints.values.size(), joints_.values.size()) << what;
    for (std::size_t i = 0; i < joints_.values.size(); ++i) {
      const Eigen::Vector2d stated = motion.joints.values[i].tail<2>();
      EXPECT_LE((stated - joints_.values[i].tail<2>()).norm(), 2e-3) << what << " " << i;
      const Eigen::Isometry3d pose = arm_->bedFromNozzle(motion.joints.values[i]);
      EXPECT_LE((pose.translation() - place_ * toolpath_.layers[0].paths[0].points[i]).norm(), 0.01) << what;
    }
  }

  std::unique_ptr<KinematicModel> arm_;
  Eigen::Isometry3d place_ = Eigen::Isometry3d(Eigen::Translation3d(1000.0, 0.0, 0.0));
  Toolpath toolpath_;
  JointPath joints_;
};

TEST_F(RobotGantry, IsLedByTheProgramsThatHaveAxesForIt) {
  ASSERT_TRUE(joints_.isRunnable());
  EXPECT_GT((joints_.values.back() - joints_.values.front()).tail<2>().minCoeff(), 500.0);
  const RobotMotion robot{*arm_, joints_};
  for (const RobotLanguage language : {RobotLanguage::Krl, RobotLanguage::Fanuc}) {
    const auto files = robotProgram(toolpath_, place_, {language, "gantry", {}}, &robot);
    expectSame(readRobotMotion(files, "part", *arm_), toString(language));
  }
  RapidSettings rapid;
  rapid.variant = RapidVariant::Powder5Axes;
  rapid.configuration = RapidConfiguration::Joints;
  const RapidProgram program(toolpath_, place_, rapid, &robot);
  std::string text;
  program.write(0, [&text](std::string_view piece) { text += piece; });
  expectSame(readRapidMotion({{"gantry.mod", text}}, "part", *arm_), "RAPID");
}

TEST_F(RobotGantry, IsRefusedByNameWhereAProgramHasNone) {
  const RobotMotion robot{*arm_, joints_};
  for (const RobotLanguage language : {RobotLanguage::UrScript, RobotLanguage::Inform}) {
    try {
      robotProgram(toolpath_, place_, {language, "gantry", {}}, &robot);
      ADD_FAILURE() << toString(language);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("2 external axes"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace lamina
