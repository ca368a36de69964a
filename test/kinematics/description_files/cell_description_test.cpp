// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/description_files/cell_description.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/arm/arm_cell.hpp"
#include "lamina/kinematics/arm/arm_controller.hpp"
#include "lamina/kinematics/description_files/robot_report.hpp"
#include "lamina/kinematics/description_files/xacro_expansion.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"
#include "lamina/kinematics/model/seen_bodies.hpp"
#include "support/arms.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

class CellFolder : public testing::Test {
 protected:
  void SetUp() override {
    std::string arm = test::exactParallelAxesArm().urdf();
    // A maker's description knows neither bed nor nozzle.
    for (const char* end : {"nozzle", "bed"}) {
      const std::string joint = std::string("<joint name=\"to_") + end + "\"";
      const std::size_t link = arm.find(std::string("<link name=\"") + end);
      arm.erase(link, arm.find("</joint>", arm.find(joint)) + 8 - link);
    }
    write("arm.urdf", arm);
    write("table.urdf",
          "<robot name=\"table\"><link name=\"foot\"/><link name=\"frame\"/><link name=\"plate\"/>"
          "<joint name=\"tilt\" type=\"revolute\"><parent link=\"foot\"/><child link=\"frame\"/><axis "
          "xyz=\"0 1 0\"/>"
          "<limit lower=\"-2\" upper=\"2\" velocity=\"1\"/></joint>"
          "<joint name=\"turn\" type=\"continuous\"><parent link=\"frame\"/><child link=\"plate\"/>"
          "<axis xyz=\"0 0 1\"/><limit velocity=\"2\"/></joint></robot>");
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.file(name)) << text;
  }
  std::string cell(const std::string& text) const { return cellDescription(text, folder_.file("cell.yaml")); }
  std::string failureOf(const std::string& text) const {
    try {
      cell(text);
      return "";
    } catch (const InvalidConfig& error) {
      return error.what();
    }
  }

  const test::ScratchFolder folder_;
};

constexpr char kPlain[] =
    "cell:\n  arm: {urdf: arm.urdf, flange_turn_deg: [0, 0, 0]}\n"
    "  tool: {xyz_mm: [0, 0, 250]}\n  bed: {xyz_mm: [600, 0, 20], size_mm: [400, 300]}\n";

TEST_F(CellFolder, ToolAndBedStandWhereItSays) {
  const std::string urdf = cell(kPlain);
  const auto model = kinematicModelFromUrdf(urdf);
  ASSERT_EQ(model->joints().size(), 6U);
  const auto links = model->bedFromLinks(JointValues::Constant(6, 0.3));
  EXPECT_TRUE((links.at("joint_6_link").inverse() * links.at("nozzle"))
                  .translation()
                  .isApprox(Point3(0, 0, 250), 1e-9));
  EXPECT_TRUE(
      (links.at("bed").inverse() * links.at("base_link")).translation().isApprox(Point3(-600, 0, -20), 1e-9));
  EXPECT_TRUE(buildSpaceFromUrdf(urdf).range.high.head<2>().isApprox(Point2(200, 150), 1e-9));
}

TEST_F(CellFolder, LoadOfTheToolIsThatOfTheArmsCell) {
  std::string arm = test::exactParallelAxesArm().urdf();
  for (const char* end : {"nozzle", "bed"}) {
    const std::string joint = std::string("<joint name=\"to_") + end + "\"";
    const std::size_t link = arm.find(std::string("<link name=\"") + end);
    arm.erase(link, arm.find("</joint>", arm.find(joint)) + 8 - link);
  }
  arm.insert(arm.find("</robot>"),
             "<link name=\"tool0\"/><joint name=\"to_tool0\" type=\"fixed\"><parent link=\"joint_6_link\"/>"
             "<child link=\"tool0\"/></joint>");
  write("arm.urdf", arm);
  std::string text = kPlain;
  EXPECT_FALSE(armCell(*kinematicModelFromUrdf(cell(text))).load);
  text.replace(text.find("250]"), 4, "250], mass_kg: 12.5, centre_mm: [0, 10, 90]");
  const auto load = armCell(*kinematicModelFromUrdf(cell(text))).load;
  ASSERT_TRUE(load);
  EXPECT_EQ(load->mass_kg, 12.5);
  EXPECT_TRUE(load->centre_mm.isApprox(Point3(0, 10, 90), 1e-9));
  text.replace(text.find(", centre_mm: [0, 10, 90]"), 24, "");
  EXPECT_NE(failureOf(text).find("has one of mass_kg and centre_mm"), std::string::npos) << failureOf(text);
}

TEST_F(CellFolder, AxesOfAGantryCarryTheArmInTheirOrder) {
  const std::string gantry =
      std::string(kPlain) +
      "  gantry: [{axis: [1, 0, 0], lower_mm: 0, upper_mm: 6000, mm_s: 500}, {axis: [0, 1, 0], lower_mm: "
      "-900, "
      "upper_mm: 900, mm_s: 400}, {axis: [0, 0, -1], lower_mm: 0, upper_mm: 700, mm_s: 300}]\n";
  const auto model = kinematicModelFromUrdf(cell(gantry));
  ASSERT_EQ(model->joints().size(), 9U);
  JointValues values = JointValues::Constant(9, 0.3);
  values.tail<3>().setZero();
  const Point3 before = model->bedFromLinks(values).at("base_link").translation();
  values.tail<3>() << 4000.0, -300.0, 500.0;
  const Point3 moved = model->bedFromLinks(values).at("base_link").translation() - before;
  EXPECT_TRUE(moved.isApprox(Point3(4000, -300, -500), 1e-9)) << moved.transpose();
  EXPECT_NEAR(model->joints()[7].max_speed, 400.0, 1e-9);
  std::string what =
      failureOf(gantry + "  rail: {axis: [0, 1, 0], lower_mm: 0, upper_mm: 2000, mm_s: 500}\n");
  EXPECT_NE(what.find("stands beside the other of rail and gantry"), std::string::npos) << what;
  what = failureOf(std::string(kPlain) +
                   "  gantry: [{axis: [1, 0, 0], lower_mm: 0, upper_mm: 6000, mm_s: 500}]\n");
  EXPECT_NE(what.find("has 1 axes; expected 2 or 3"), std::string::npos) << what;
}

TEST_F(CellFolder, ControllersAreWhatACellStates) {
  const std::string plain = kPlain;
  EXPECT_FALSE(armController(cell(plain)));
  const auto controller =
      armController(cell(
          plain + "  controller: {kind: fanuc, sign: [-1, 1, 1, 1, 1, 1], zero_deg: [0, -90, 90.5, 0, 0, 0], "
                  "j3_from_j2: -0.5, tool_number: 3, frame_number: 4}\n"));
  ASSERT_TRUE(controller);
  EXPECT_EQ(controller->kind, "fanuc");
  EXPECT_EQ(controller->signs, (std::vector<double>{-1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(controller->zeros_deg, (std::vector<double>{0, -90, 90.5, 0, 0, 0}));
  EXPECT_EQ(controller->joint_3_from_2, -0.5);
  EXPECT_EQ(controller->tool_number, 3);
  EXPECT_EQ(controller->frame_number, 4);
  // The first of Yaskawa and Fanuc, which is no empty entry.
  for (const char* kind : {"yaskawa", "fanuc"}) {
    const auto bare = armController(cell(plain + "  controller: {kind: " + kind + ", tool_number: 0}\n"));
    ASSERT_TRUE(bare) << kind;
    EXPECT_EQ(bare->tool_number, 0) << kind;
  }
  for (const auto& [entry, what] :
       {std::pair("{kind: siemens}", "is 'siemens'; expected abb, kuka, fanuc, yaskawa or ur"),
        std::pair("{sign: [1, 1, 1, 1, 1, 1]}", "has no kind"),
        std::pair("{kind: kuka, sign: [1, 1]}", "has 2 numbers; expected 6"),
        std::pair("{kind: kuka, sign: [0.5, 1, 1, 1, 1, 1]}", "has the sign 0.5; expected 1 or -1"),
        std::pair("{kind: kuka, j3_from_j2: -1}", "expected it with fanuc alone"),
        std::pair("{kind: kuka, tool_number: 0}", "has a number of 0 with kind 'kuka'; expected 1 or more"),
        std::pair("{kind: yaskawa, tool_number: -1}", "is -1; expected a whole number, 0 to 32"),
        std::pair("{kind: abb, tool_number: 2}", "more than its kind with kind 'abb'")}) {
    const std::string refusal = failureOf(plain + "  controller: " + entry + "\n");
    EXPECT_NE(refusal.find(what), std::string::npos) << refusal;
  }
}

TEST_F(CellFolder, FourExternalAxesAreRefusedByTheirNumber) {
  const std::string urdf =
      cell(std::string(kPlain) +
           "  gantry: [{axis: [1, 0, 0], lower_mm: 0, upper_mm: 60, mm_s: 5}, {axis: [0, 1, 0], lower_mm: 0, "
           "upper_mm: 9, mm_s: 4}, {axis: [0, 0, 1], lower_mm: 0, upper_mm: 7, mm_s: 3}]\n");
  EXPECT_EQ(kinematicModelFromUrdf(urdf)->joints().size(), 9U);
  // An arm of five joints leaves room for four in a machine.
  std::string five = test::gantryArm();
  const auto replace = [&five](const std::string& from, const std::string& to) {
    five.replace(five.find(from), from.size(), to);
  };
  const std::string on_room = "<parent link=\"room\"/><child link=\"bridge\"/>";
  replace(on_room, "<parent link=\"slide\"/><child link=\"bridge\"/>");
  const std::string range = "lower=\"0\" upper=\"1\"";
  replace(
      "<link name=\"bridge\"/>",
      "<link name=\"bridge\"/><link name=\"rise\"/><link name=\"slide\"/>" +
          test::linearJoint("external_3", "<parent link=\"room\"/><child link=\"rise\"/>", "0 0 1", range) +
          test::linearJoint("external_4", "<parent link=\"rise\"/><child link=\"slide\"/>", "0 0 1", range));
  const std::size_t type = five.find("type=\"", five.find("<joint name=\"joint_6\"")) + 6;
  five.replace(type, five.find('"', type) - type, "fixed");
  try {
    kinematicModelFromUrdf(five);
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("has 4 external axes; expected 3 at most"), std::string::npos)
        << error.what();
  }
}

TEST_F(CellFolder, TheNozzlePointsAlongTheAxisOfTheToolUnderItsFormerNameToo) {
  for (const char* key : {"axis", "jet"}) {
    std::string text = kPlain;
    text.replace(text.find("250]"), 4, std::string("250], ") + key + ": x");
    const auto links = kinematicModelFromUrdf(cell(text))->bedFromLinks(JointValues::Zero(6));
    const Point3 pointed = (links.at("joint_6_link").inverse() * links.at("nozzle")).linear().col(2);
    EXPECT_TRUE(pointed.isApprox(Point3::UnitX(), 1e-9)) << key;
  }
}

TEST_F(CellFolder, RailAndPositionerAreExternalAxesInThisOrder) {
  const auto model = kinematicModelFromUrdf(
      cell(std::string(kPlain) + "  rail: {axis: [0, 1, 0], lower_mm: 0, upper_mm: 2000, mm_s: 500}\n"
                                 "  positioner: {urdf: table.urdf, flange: plate, xyz_mm: [900, 0, 0]}\n"));
  ASSERT_EQ(model->joints().size(), 9U);
  EXPECT_EQ(model->joints()[6].kind, JointKind::Linear);
  EXPECT_EQ(model->joints()[6].high, 2000.0);
  EXPECT_EQ(model->joints()[7].high, 2.0);
  EXPECT_EQ(model->joints()[8].max_speed, 2.0);
  JointValues values = JointValues::Constant(9, 0.2);
  values[6] = 700.0;
  const auto solutions = model->solutions(model->bedFromNozzle(values), values);
  EXPECT_FALSE(solutions.empty());
  for (const InverseSolution& each : solutions)
    EXPECT_LT(test::distance(model->bedFromNozzle(each.values), model->bedFromNozzle(values)), 1e-9);
}

constexpr char kTiltingTable[] = "  positioner: {urdf: table.urdf, flange: plate, xyz_mm: [900, 0, 0]}\n";

/// A table whose joint next to the plate comes first, by its name and by the order of the elements.
/// @param more  elements besides
std::string turnBeforeTilt(const std::string& more) {
  return "<robot name=\"table\"><link name=\"plate\"/><link name=\"frame\"/><link name=\"foot\"/>"
         "<joint name=\"a_turn\" type=\"continuous\"><parent link=\"frame\"/><child link=\"plate\"/>"
         "<axis xyz=\"0 0 1\"/><limit velocity=\"2\"/></joint>" +
         more +
         "<joint name=\"b_tilt\" type=\"revolute\"><parent link=\"foot\"/><child link=\"frame\"/>"
         "<axis xyz=\"0 1 0\"/><limit lower=\"-1.5\" upper=\"2\" velocity=\"1\"/></joint></robot>";
}

TEST_F(CellFolder, AxesOfAPositionerAreNumberedOutwardInAnyOrderOfTheirElements) {
  write("table.urdf", turnBeforeTilt(""));
  const auto model = kinematicModelFromUrdf(cell(std::string(kPlain) + kTiltingTable));
  ASSERT_EQ(model->joints().size(), 8U);
  EXPECT_EQ(model->joints()[6].name, "external_1");
  EXPECT_EQ(model->joints()[6].low, -1.5) << "the tilt, which carries the turn";
  EXPECT_EQ(model->joints()[7].name, "external_2");
  EXPECT_EQ(model->joints()[7].max_speed, 2.0);
}

TEST_F(CellFolder, ARodOfAPositionerFollowsItsAxis) {
  write("table.urdf",
        turnBeforeTilt("<link name=\"rod\"/><joint name=\"rod\" type=\"revolute\"><parent link=\"foot\"/>"
                       "<child link=\"rod\"/><axis xyz=\"0 1 0\"/><mimic joint=\"b_tilt\" multiplier=\"-2\"/>"
                       "<limit lower=\"-4\" upper=\"4\" velocity=\"2\"/></joint>"));
  const auto model = kinematicModelFromUrdf(cell(std::string(kPlain) + kTiltingTable));
  ASSERT_EQ(model->joints().size(), 8U);
  JointValues values = JointValues::Constant(8, 0.1);
  values[6] = 0.4;
  const auto links = model->bedFromLinks(values);
  const auto turned = [&](const char* link) {
    const Eigen::Matrix3d turn = (links.at("positioner_foot").inverse() * links.at(link)).linear();
    return std::atan2(turn(0, 2), turn(2, 2));
  };
  EXPECT_NEAR(turned("positioner_frame"), 0.4, 1e-9);
  EXPECT_NEAR(turned("positioner_rod"), -0.8, 1e-9);
}

TEST_F(CellFolder, BedIsSeenAndMaterialsOfOneNameDoNotMeet) {
  for (const char* name : {"arm.urdf", "table.urdf"}) {
    std::ifstream file(folder_.file(name));
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const bool is_arm = std::string(name) == "arm.urdf";
    const std::string link = is_arm ? "<link name=\"base_link\"/>" : "<link name=\"plate\"/>";
    const std::string seen = link.substr(0, link.size() - 2) +
                             "><visual><geometry><box size=\"0.1 0.2 0.3\"/></geometry><material "
                             "name=\"paint\"/></visual></link>";
    text.replace(text.find(link), link.size(),
                 std::string("<material name=\"paint\"><color rgba=\"") + (is_arm ? "1 0 0 1" : "0 0 1 1") +
                     "\"/></material>" + seen);
    write(name, text);
  }
  const std::vector<DisplayBody> seen = displayBodies(
      cell(std::string(kPlain) + "  positioner: {urdf: table.urdf, flange: plate, xyz_mm: [900, 0, 0]}\n"));
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_EQ(seen[0].link, "base_link");
  EXPECT_EQ(seen[0].colour, (std::array<double, 3>{1.0, 0.0, 0.0}));
  EXPECT_EQ(seen[1].link, "bed");
  const Box3 plate = boundingBox(seen[1].mesh);
  EXPECT_TRUE(plate.low.isApprox(Point3(-200, -150, -20), 1e-9));
  EXPECT_TRUE(plate.high.isApprox(Point3(200, 150, 0), 1e-9));
  EXPECT_EQ(seen[2].link, "positioner_plate");
  EXPECT_EQ(seen[2].colour, (std::array<double, 3>{0.0, 0.0, 1.0}));
}

TEST_F(CellFolder, AProfileIsNoCell) {
  write("profile.yaml", "profile: {kind: machine, name: own}\nmachine: {name: irb_4600}\n");
  write("cell.yaml", kPlain);
  write("broken.yaml", "cell: [\n");
  EXPECT_TRUE(holdsCell(folder_.file("cell.yaml")));
  for (const char* name : {"profile.yaml", "broken.yaml", "missing.yaml", "arm.urdf"})
    EXPECT_FALSE(holdsCell(folder_.file(name))) << name;
}

TEST_F(CellFolder, WhatIsWrongIsRefusedAsAWhole) {
  EXPECT_NE(failureOf("cell:\n  arm: {urdf: arm.urdf}\n").find("lacks arm or bed"), std::string::npos);
  EXPECT_NE(failureOf(std::string(kPlain) + "  gantry: 1\n"), "");
  // Joint 6 turns about y of the last link.
  EXPECT_NE(
      failureOf("cell:\n  arm: {urdf: arm.urdf}\n  bed: {size_mm: [1, 1]}\n")
          .find(
              "lies across the last axis; expected cell.arm.flange_turn_deg, by which it is turned: [0, 90, "
              "90] along it, or [0, -90, 90] against it"),
      std::string::npos);
  EXPECT_NE(failureOf(std::string(kPlain) + "  positioner: {urdf: arm.urdf}\n").find("has 6 driven joints"),
            std::string::npos);
}

std::string withLimits(const std::string& limits) {
  std::string text = kPlain;
  return text.insert(text.find("flange_turn_deg"), "limits: {" + limits + "}, ");
}

TEST_F(CellFolder, LimitsOfTheArmAreNarrowedAndOnlyWidenedIfSaid) {
  const auto joints = kinematicModelFromUrdf(cell(kPlain))->joints();
  const double low_deg = toDegrees(joints[1].low);
  const auto narrowed =
      kinematicModelFromUrdf(cell(withLimits("joint_2: {upper_deg: 30, deg_s: 6}")))->joints();
  EXPECT_NEAR(toDegrees(narrowed[1].high), 30.0, 1e-9);
  EXPECT_NEAR(toDegrees(narrowed[1].low), low_deg, 1e-9);
  EXPECT_NEAR(toDegrees(narrowed[1].max_speed), 6.0, 1e-9);
  EXPECT_EQ(narrowed[2].high, joints[2].high);
  const std::string wide = "lower_deg: " + std::to_string(low_deg - 5.0);
  EXPECT_NE(failureOf(withLimits("joint_2: {" + wide + "}")).find("lower_deg of joint 'joint_2' is "),
            std::string::npos)
      << failureOf(withLimits("joint_2: {" + wide + "}"));
  EXPECT_NE(failureOf(withLimits("joint_2: {deg_s: 1e5}")).find("or wider: true"), std::string::npos);
  const auto widened = kinematicModelFromUrdf(cell(withLimits("joint_2: {" + wide + ", wider: true}")));
  EXPECT_NEAR(toDegrees(widened->joints()[1].low), low_deg - 5.0, 1e-5);
}

TEST_F(CellFolder, LimitsOfWhatIsNoDrivenJointAreRefused) {
  EXPECT_NE(failureOf(withLimits("joint_9: {deg_s: 1}")).find("has no joint 'joint_9'"), std::string::npos);
  EXPECT_NE(failureOf(withLimits("joint_2: {deg_s2: 1}")).find("deg_s2"), std::string::npos);
  EXPECT_NE(failureOf(withLimits("joint_2: {deg_s: 0}")).find("expected a positive number"),
            std::string::npos);
  // What is left of a joint whose bounds meet is no joint.
  EXPECT_NE(failureOf(withLimits("joint_2: {lower_deg: 10, upper_deg: 10}")), "");
}

TEST_F(CellFolder, ASpeedThatADescriptionLacksMayBeStated) {
  std::ifstream file(folder_.file("arm.urdf"));
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t joint = text.find("<joint name=\"joint_3\"");
  const std::size_t speed = text.find("velocity=\"", joint) + 10;
  text.replace(speed, text.find('"', speed) - speed, "0");
  write("arm.urdf", text);
  EXPECT_NE(failureOf(kPlain).find("has a velocity of 0"), std::string::npos) << failureOf(kPlain);
  std::string bare = text;
  bare.replace(speed - 10, 12, "");
  write("arm.urdf", bare);
  EXPECT_NE(failureOf(kPlain).find("has no velocity; expected one in its limit, or in cell.arm.limits"),
            std::string::npos)
      << failureOf(kPlain);
  write("arm.urdf", text);
  const auto arm = kinematicModelFromUrdf(cell(withLimits("joint_3: {deg_s: 90}")));
  EXPECT_NEAR(toDegrees(arm->joints()[2].max_speed), 90.0, 1e-9);
}

TEST_F(CellFolder, AReportNamesClassAndTraps) {
  const RobotReport report = robotReport(cell(kPlain));
  EXPECT_EQ(report.kinematic_class, "three parallel axes");
  EXPECT_EQ(report.joints.size(), 6U);
  // Upper arm, forearm and wrist stretched out: 612.7 + 571.55 mm, and the wrist's own.
  EXPECT_GT(report.reach_mm, 1150.0);
  EXPECT_LT(report.reach_mm, 1700.0);
  EXPECT_FALSE(report.traps.empty());
}

TEST_F(CellFolder, LinksThatItIgnoresAreNotCheckedAgainstEachOther) {
  const LinkBodies bodies =
      linkBodies(cell(std::string(kPlain) + "  ignore: [[bed, joint_3_link], [nozzle, joint_2_link]]\n"));
  EXPECT_TRUE(areUnchecked(bodies, "joint_3_link", "bed"));
  EXPECT_TRUE(areUnchecked(bodies, "nozzle", "joint_2_link"));
  EXPECT_FALSE(areUnchecked(bodies, "joint_3_link", "joint_2_link"));
  EXPECT_EQ(uncheckedLinks(bodies).back(), (std::pair<std::string, std::string>{"nozzle", "joint_2_link"}));
  const auto ofMissing = [&] { linkBodies(cell(std::string(kPlain) + "  ignore: [[bed, hose]]\n")); };
  try {
    ofMissing();
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("no link 'hose', which is to be ignored"), std::string::npos);
  }
  EXPECT_NE(failureOf(std::string(kPlain) + "  ignore: [[bed]]\n").find("names no two links"),
            std::string::npos);
}

// R4: of a maker's arm nothing but neighbours goes unchecked.
TEST(RobotReportOfAnArm, ListsNeighboursAloneAsUnchecked) {
  const RobotReport report = robotReport(kinematicModelByName("irb_4600")->urdf());
  using Names = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(report.unchecked, (Names{{"base_link", "link_1"},
                                     {"link_1", "link_2"},
                                     {"link_2", "link_3"},
                                     {"link_3", "link_4"},
                                     {"link_4", "link_5"},
                                     {"link_5", "link_6"}}));
}

// A tool, a positioner and fences hang on links that joints connect, and are no neighbours of these.
TEST(RobotReportOfACell, ListsNeighboursAloneAsUnchecked) {
  const std::string file = std::string(LAMINA_SOURCE_DIR) + "/examples/robots/tilting_cell/cell.yaml";
  using Names = std::vector<std::pair<std::string, std::string>>;
  const Names arm = {{"base_link", "link_1"}, {"link_1", "link_2"}, {"link_2", "link_3"},
                     {"link_3", "link_4"},    {"link_4", "link_5"}, {"link_5", "link_6"}};
  Names cell = arm;
  cell.push_back({"positioner_frame", "positioner_cradle"});
  cell.push_back({"positioner_cradle", "positioner_plate"});
  EXPECT_EQ(robotReport(readMachineDescription(file)).unchecked, cell);
  const std::string on_rail =
      "cell:\n  packages: [.]\n  arm: {urdf: seam_arm_support/urdf/seam_arm.urdf, flange: tool0}\n"
      "  rail: {axis: [0, 1, 0], lower_mm: -2000, upper_mm: 2000, mm_s: 500}\n"
      "  bed: {xyz_mm: [1150, 0, 770], size_mm: [300, 300]}\n  bodies: [{mesh: head.stl}]\n";
  EXPECT_EQ(robotReport(cellDescription(on_rail, file)).unchecked, arm);
}

TEST_F(CellFolder, XacroBecomesTheSameUrdf) {
  write("limits.yaml", "lift: {upper: !degrees 180, name: up}\n");
  write("part.xacro",
        "<robot xmlns:xacro=\"http://ros.org/wiki/xacro\"><xacro:macro name=\"part\" params=\"prefix size:=2 "
        "*origin\">"
        "<link name=\"${prefix}link\"><visual><xacro:insert_block name=\"origin\"/><geometry>"
        "<sphere radius=\"${size * 0.25 + radians(180) - "
        "pi}\"/></geometry></visual></link></xacro:macro></robot>");
  write("arm.xacro",
        "<robot name=\"a\" xmlns:xacro=\"http://ros.org/wiki/xacro\"><xacro:arg name=\"side\" "
        "default=\"left\"/>"
        "<xacro:include filename=\"part.xacro\"/><xacro:property name=\"l\" "
        "value=\"${load_yaml('limits.yaml')}\"/>"
        "<xacro:part prefix=\"$(arg side)_\"><origin xyz=\"${-(1+2)/4} 0 ${l['lift']['upper']}\" "
        "rpy=\"0 0 ${l['lift']['upper']}\"/></xacro:part>"
        "<xacro:if value=\"${'$(arg side)' == 'right'}\"><link name=\"only_right\"/></xacro:if></robot>");
  const std::string left = expandXacro(folder_.file("arm.xacro"));
  EXPECT_NE(left.find("<link name=\"left_link\">"), std::string::npos) << left;
  EXPECT_NE(left.find("<origin xyz=\"-0.75 0 3.1415926535897931\" rpy=\"0 0 3.1415926535897931\""),
            std::string::npos)
      << left;
  EXPECT_NE(left.find("<sphere radius=\"0.5\""), std::string::npos) << left;
  EXPECT_EQ(left.find("only_right"), std::string::npos);
  EXPECT_EQ(left.find("xacro"), std::string::npos);
  write("bad.xacro", "<robot xmlns:xacro=\"x\">\n<xacro:call macro=\"part\"/></robot>");
  try {
    expandXacro(folder_.file("bad.xacro"));
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("bad.xacro, line 2: <xacro:call> is not understood"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace lamina
