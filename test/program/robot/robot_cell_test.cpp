// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/robot_cell.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdio>

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
#include "support/tilting_arm.hpp"
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

/// The controller has the axis across first, which it counts the other way from 3 m on.
constexpr const char* kSwapped = "external_1=e2, external_2=-e1+3000";

TEST_F(RobotGantry, IsWrittenAsTheControllerOrdersAndCountsItsAxes) {
  const RobotMotion robot{*arm_, joints_};
  RobotProgramSettings settings;
  settings.external_axes = kSwapped;
  const Eigen::Vector2d last = joints_.values.back().tail<2>();
  const auto number = [](double value, int decimals) {
    char text[40];
    std::snprintf(text, sizeof(text), "%.*f", decimals, value);
    return std::string(text);
  };
  const auto krl = robotProgram(toolpath_, place_, {RobotLanguage::Krl, "gantry", settings}, &robot);
  const std::string in_krl = ",E1 " + number(3000.0 - last[1], 4) + ",E2 " + number(last[0], 4) + "}";
  EXPECT_NE(krl[0].text.find(in_krl), std::string::npos) << in_krl << "\n" << krl[0].text.substr(0, 3000);
  expectSame(readRobotMotion(krl, "part", *arm_), "KRL");
  const auto fanuc = robotProgram(toolpath_, place_, {RobotLanguage::Fanuc, "gantry", settings}, &robot);
  expectSame(readRobotMotion(fanuc, "part", *arm_), "Fanuc");
  const auto plain = robotProgram(toolpath_, place_, {RobotLanguage::Fanuc, "gantry", {}}, &robot);
  EXPECT_NE(fanuc[0].text, plain[0].text);
}

TEST_F(RobotGantry, IsCarriedByBaseAxesInJobsOfInform) {
  const RobotMotion robot{*arm_, joints_};
  RobotProgramSettings settings;
  settings.external_axes = kSwapped;
  settings.inform.external_pulses = {1000.0, -2000.0};
  const auto files = robotProgram(toolpath_, place_, {RobotLanguage::Inform, "gantry", settings}, &robot);
  const std::string& text = files[0].text;
  const Eigen::Vector2d last = joints_.values.back().tail<2>();
  const std::string base = "=" + std::to_string(std::lround(1000.0 * (3000.0 - last[1]))) + "," +
                           std::to_string(std::lround(-2000.0 * last[0])) + "\r\n";
  EXPECT_NE(text.find(base), std::string::npos) << base << text;
  // A move of the joints, 41 of the tip, and the way off the part.
  EXPECT_NE(text.find("///NPOS 43,43,0,0,0,0\r\n"), std::string::npos) << text;
  EXPECT_NE(text.find("MOVJ C00000 BC00000 VJ=10.00\r\n"), std::string::npos) << text;
  EXPECT_NE(text.find("MOVL C00041 BC00041 V=50.0 PL=0\r\n"), std::string::npos) << text;
  EXPECT_NE(text.find("///GROUP1 RB1,BS1\r\nNOP\r\n"), std::string::npos) << text;
  expectSame(readRobotMotion(files, "part", *arm_), "INFORM");
  settings.inform.pulses_per_deg = {1000, 1000, 1000, 500, 500, 250.5};
  const auto in_pulses = robotProgram(toolpath_, place_, {RobotLanguage::Inform, "gantry", settings}, &robot);
  expectSame(readRobotMotion(in_pulses, "part", *arm_), "INFORM in pulses");
  settings.inform.external_pulses = {1000.0};
  EXPECT_THROW(robotProgram(toolpath_, place_, {RobotLanguage::Inform, "gantry", settings}, &robot),
               InvalidInput);
}

TEST_F(RobotGantry, JobsWhosePointsOfExternalAxesAreNotAsStatedAreRefused) {
  const RobotMotion robot{*arm_, joints_};
  RobotProgramSettings settings;
  settings.inform.external_pulses = {1000.0, 1000.0};
  const auto files = robotProgram(toolpath_, place_, {RobotLanguage::Inform, "gantry", settings}, &robot);
  const auto refusal = [&](const std::string& what, const std::string& by) -> std::string {
    auto changed = files;
    const std::size_t at = changed[0].text.find(what);
    if (at == std::string::npos) return "'" + what + "' is not there";
    changed[0].text.replace(at, what.size(), by);
    try {
      readRobotMotion(changed, "part", *arm_);
      return "";
    } catch (const InvalidProgram& error) {
      return error.what();
    }
  };
  const auto isRefused = [&](const std::string& what, const std::string& by, const std::string& expected) {
    EXPECT_NE(refusal(what, by).find(expected), std::string::npos) << refusal(what, by);
  };
  isRefused("'# external_pulses 1000 1000", "'# external_pulses 1000", "a note 'external_pulses'");
  isRefused("'# external_pulses 1000 1000", "'# external_pulses 1000 0", "pulses in a mm or a degree");
  isRefused("///NPOS 43,43,", "///NPOS 43,42,", "expected 42, as ///NPOS says");
  isRefused("MOVL C00002 BC00002 ", "MOVL C00002 BC00001 ", "each point in one move");
  isRefused("MOVL C00002 BC00002 ", "MOVL BC00002 ", "a point of the arm");
  isRefused("MOVL C00002 BC00002 ", "MOVL C00002 ", "a move has 0 external axes");
}

TEST_F(RobotGantry, AxesThatItDoesNotHaveAreRefusedByName) {
  const RobotMotion robot{*arm_, joints_};
  const auto refusal = [&](const std::string& axes, const RobotMotion* motion) -> std::string {
    RobotProgramSettings settings;
    settings.external_axes = axes;
    try {
      robotProgram(toolpath_, place_, {RobotLanguage::Krl, "gantry", settings}, motion);
      return "";
    } catch (const InvalidConfig& error) {
      return error.what();
    }
  };
  EXPECT_NE(refusal("external_1=e1", &robot).find("do not name joint external_2"), std::string::npos);
  EXPECT_NE(refusal("external_1=e1,external_9=e2", &robot).find("name joint external_9"), std::string::npos);
  EXPECT_NE(refusal("external_1=e1,external_2=e3", &robot).find("names e3 without e2"), std::string::npos);
  for (const char* wrong : {"external_1=e7,external_2=e1", "external_1=e1+-5,external_2=e2",
                            "external_1=e1--5,external_2=e2", "external_1=e1++5,external_2=e2"})
    EXPECT_NE(refusal(wrong, &robot).find("expected joint=axis"), std::string::npos) << wrong;
  EXPECT_NE(refusal(kSwapped, nullptr).find("without an arm"), std::string::npos);
}

/// Why no program is written over a table that is held turned; empty if one is.
std::string refusalOverTable(double held_deg, const RobotProgramRequest& order) {
  NoProgress nobody;
  const auto arm = kinematicModelByName("irb_4600_turntable");
  const Toolpath toolpath = test::twoLayers();
  const Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  JointPathSettings planning;
  planning.external_deg = held_deg;
  const JointPath joints = planJointPath(toolpath, place, *arm, planning, nobody);
  const RobotMotion robot{*arm, joints};
  try {
    robotProgram(toolpath, place, order, &robot);
    return "";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

/// The frame was measured with the joint at zero, whatever the controller counts there.
TEST(RobotCell, TablesAreHeldWhereTheirJointIsAtZero) {
  RobotProgramSettings settings;
  settings.fanuc.is_coordinated = false;
  settings.external_axes = "external_1=-e1+90";
  const auto refusal = [&](double held_deg) {
    return refusalOverTable(held_deg, {RobotLanguage::Fanuc, "part", settings});
  };
  EXPECT_EQ(refusal(0.0), "");
  EXPECT_NE(refusal(90.0).find("axis external_1 turns the bed to 0 deg; expected true, or 90 deg"),
            std::string::npos)
      << refusal(90.0);
}

/// A table held turned, which the controller counts the other way.
TEST(RobotCell, JobsOverATableMoveItsStation) {
  NoProgress nobody;
  const auto arm = kinematicModelByName("irb_4600_turntable");
  const Toolpath toolpath = test::twoLayers();
  const Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  JointPathSettings planning;
  planning.external_deg = 30.0;
  const JointPath joints = planJointPath(toolpath, place, *arm, planning, nobody);
  const RobotMotion robot{*arm, joints};
  RobotProgramSettings settings;
  settings.external_axes = "external_1=-e1+90";
  settings.inform.external_pulses = {1000.0};
  settings.inform.pulses_per_deg = {1000, 1000, 1000, 500, 500, 250};
  const auto files = robotProgram(toolpath, place, {RobotLanguage::Inform, "part", settings}, &robot);
  const std::string& text = files[0].text;
  EXPECT_NE(text.find("\r\nEC00001=60000\r\n"), std::string::npos) << text;
  EXPECT_NE(text.find("///GROUP1 RB1\r\n///GROUP2 ST1\r\n"), std::string::npos) << text;
  EXPECT_NE(text.find("MOVJ C00000 VJ=10.00 +MOVJ EC00000 VJ=10.00\r\n"), std::string::npos) << text;
  EXPECT_NE(text.find("SMOVL C00001 V="), std::string::npos) << text;
  EXPECT_NE(text.find(" +MOVJ EC00001\r\n"), std::string::npos) << text;
  const StatedMotion motion = readRobotMotion(files, "part", *arm);
  ASSERT_EQ(motion.joints.values.size(), joints.values.size());
  for (const JointValues& values : motion.joints.values)
    EXPECT_NEAR(toDegrees(values[values.size() - 1]), 30.0, 1e-3);
  settings.inform.is_coordinated = false;
  EXPECT_THROW(robotProgram(toolpath, place, {RobotLanguage::Inform, "part", settings}, &robot),
               InvalidInput);
  planning.external_deg = 0.0;
  const JointPath held = planJointPath(toolpath, place, *arm, planning, nobody);
  const RobotMotion still{*arm, held};
  const auto apart = robotProgram(toolpath, place, {RobotLanguage::Inform, "part", settings}, &still);
  EXPECT_NE(apart[0].text.find(" +MOVJ EC00001 VJ=10.00\r\n"), std::string::npos) << apart[0].text;
  EXPECT_EQ(apart[0].text.find("SMOVL"), std::string::npos);
  EXPECT_NO_THROW(readRobotMotion(apart, "part", *arm));
}

/// `MOVJ` takes a pose over the frame where the joint of the table is at zero: 30 deg about it beside the
/// part.
TEST(RobotCell, JobsGoToNoPoseOverATurnedTableByAMoveOfTheJoints) {
  RobotProgramSettings settings;
  settings.external_axes = "external_1=-e1+90";
  settings.inform.external_pulses = {1000.0};
  const auto refusal = [&](double held_deg) {
    return refusalOverTable(held_deg, {RobotLanguage::Inform, "part", settings});
  };
  EXPECT_EQ(refusal(0.0), "");
  EXPECT_EQ(
      refusal(30.0),
      "inform.pulses_per_deg is empty, so that a move of the joints goes to a pose over a frame that "
      "stands still, and axis external_1 turns the bed to 60 deg; expected the pulses of each joint, or "
      "90 deg (joints.external 'held')");
  settings.inform.is_coordinated = false;
  EXPECT_NE(refusal(30.0).find("inform.coordinated is false, and axis external_1"), std::string::npos);
  settings.inform.is_coordinated = true;
  settings.inform.pulses_per_deg = {1000, 1000, 1000, 500, 500, 250};
  EXPECT_EQ(refusal(30.0), "");
}

/// An arm on a slewing base beside a bed that stands still.
std::string slewingArm() {
  std::string urdf = kinematicModelByName("irb_4600_turntable")->urdf();
  const auto replaceOne = [&urdf](const std::string& from, const std::string& to) {
    const std::size_t at = urdf.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    urdf.replace(at, from.size(), to);
  };
  replaceOne("<joint name=\"joint_1\" type=\"revolute\">\n    <parent link=\"base_link\"/>",
             "<joint name=\"joint_1\" type=\"revolute\">\n    <parent link=\"slew\"/>");
  replaceOne("<joint name=\"external_1\" type=\"revolute\">",
             "<link name=\"slew\"/><joint name=\"external_1\" type=\"revolute\"><parent link=\"base_link\"/>"
             "<child link=\"slew\"/><axis xyz=\"0 0 1\"/><limit lower=\"-3\" upper=\"3\" velocity=\"1\" "
             "effort=\"1\"/></joint><joint name=\"to_bed\" type=\"fixed\">");
  return urdf;
}

/// What is coordinated is a bed that is carried.
TEST(RobotCell, AStationThatTurnsTheArmGoesBesideIt) {
  NoProgress nobody;
  const auto arm = kinematicModelFromUrdf(slewingArm());
  const Toolpath toolpath = test::twoLayers();
  const Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  const JointPath joints = planJointPath(toolpath, place, *arm, {}, nobody);
  const RobotMotion robot{*arm, joints};
  RobotProgramSettings settings;
  settings.inform.external_pulses = {1000.0};
  const auto job = robotProgram(toolpath, place, {RobotLanguage::Inform, "part", settings}, &robot);
  EXPECT_EQ(job[0].text.find("SMOVL"), std::string::npos);
  EXPECT_NE(job[0].text.find(" +MOVJ EC00001 VJ=10.00\r\n"), std::string::npos) << job[0].text;
  const auto listing = robotProgram(toolpath, place, {RobotLanguage::Fanuc, "part", settings}, &robot);
  EXPECT_NE(listing[0].text.find(":L P["), std::string::npos) << listing[0].text;
  EXPECT_EQ(listing[0].text.find(" COORD "), std::string::npos) << listing[0].text;
}

/// Listings of Fanuc hold rails before what turns.
TEST(RobotCell, RailsBehindWhatTurnsAreRefusedInListings) {
  const auto arm = kinematicModelFromUrdf(test::tiltingArm());
  RobotProgramSettings settings;
  settings.external_axes = "external_1=e2,external_2=-e1+90";
  EXPECT_NO_THROW(requireWritable({RobotLanguage::Fanuc, "part", settings}, *arm));
  std::string urdf = test::tiltingArm();
  const std::string tilt = "name=\"external_1\" type=\"revolute\"";
  urdf.replace(urdf.find(tilt), tilt.size(), "name=\"external_1\" type=\"prismatic\"");
  const auto sliding = kinematicModelFromUrdf(urdf);
  EXPECT_THROW(requireWritable({RobotLanguage::Fanuc, "part", settings}, *sliding), InvalidConfig);
  EXPECT_NO_THROW(requireWritable({RobotLanguage::Krl, "part", settings}, *sliding));
  // The order of the joints may be wrong too.
  std::string turning_first = test::tiltingArm();
  const std::string turn = "name=\"external_2\" type=\"continuous\"";
  turning_first.replace(turning_first.find(turn), turn.size(), "name=\"external_2\" type=\"prismatic\"");
  const std::string limit = "velocity=\"2\"";
  turning_first.replace(turning_first.find(limit), limit.size(), "lower=\"-1\" upper=\"1\" velocity=\"2\"");
  const auto tipping = kinematicModelFromUrdf(turning_first);
  EXPECT_THROW(requireWritable({RobotLanguage::Fanuc, "part", {}}, *tipping), InvalidConfig);
}

/// A program that counts an axis of another arm would be followed wrongly.
TEST_F(RobotGantry, ProgramsOfOtherAxesAreRefused) {
  const RobotMotion robot{*arm_, joints_};
  RobotProgramSettings settings;
  settings.external_axes = kSwapped;
  auto files = robotProgram(toolpath_, place_, {RobotLanguage::Krl, "gantry", settings}, &robot);
  std::string& text = files[0].text;
  const std::string note = "external external_2 -1 3000";
  ASSERT_NE(text.find(note), std::string::npos) << text.substr(0, 2000);
  const std::string whole = text;
  text.replace(text.find(note), note.size(), "external external_3 -1 3000");
  EXPECT_THROW(readRobotMotion(files, "part", *arm_), InvalidProgram);
  text = whole;
  text.replace(text.find(note), note.size(), "external external_1 -1 3000");
  EXPECT_THROW(readRobotMotion(files, "part", *arm_), InvalidProgram);
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
