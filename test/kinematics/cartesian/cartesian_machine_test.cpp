// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {
namespace {

/// Of the machines whose sensor looks straight down: its place over the nozzle.
const std::vector<std::pair<std::string, Point3>> kSensors = {{"cartesian_gantry", {25, 0, 60}},
                                                              {"drop_printer", {25, 0, 60}},
                                                              {"gantry_45", {25, 0, 60}},
                                                              {"large_gantry_45", {150, 0, 250}},
                                                              {"large_gantry_45_reverse", {150, 0, 250}}};

/// Why the settings name no machine of linear axes; empty if they do.
std::string refusalOfMachine(const MachineSettings& settings) {
  try {
    machineOf(settings);
    return "";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

/// Text of the gantry with one part of it replaced.
std::string gantryWith(const std::string& what, const std::string& by) {
  std::string text = machineByName("cartesian_gantry").urdf;
  text.replace(text.find(what), what.size(), by);
  return text;
}

TEST(CartesianMachine, AxesOfTheGantryAreTheCoordinatesOfItsBed) {
  const CartesianMachine machine = machineByName("cartesian_gantry");
  const Eigen::Isometry3d bed_from_nozzle = bedFromNozzle(machine, {10, 20, 30});
  EXPECT_TRUE(bed_from_nozzle.translation().isApprox(Point3(10, 20, 30)));
  EXPECT_TRUE(bed_from_nozzle.linear().isApprox(nozzleDown().toRotationMatrix(), 1e-9));
  EXPECT_TRUE(boundingBox(buildSpaceOf(machine)).low.isZero(1e-9));
  EXPECT_TRUE(boundingBox(buildSpaceOf(machine)).high.isApprox(Point3(220, 220, 250)));
  EXPECT_DOUBLE_EQ(machine.axes[2].max_speed_mm_s, 200.0);
}

TEST(CartesianMachine, HeadOf45DegreesPointsDownAndBack) {
  const CartesianMachine machine = machineByName("gantry_45");
  const Point3 tool_axis = bedFromNozzle(machine, {10, 20, 30}).linear().col(2);
  EXPECT_TRUE(tool_axis.isApprox(Point3(0, M_SQRT1_2, -M_SQRT1_2), 1e-9));
  EXPECT_TRUE(bedFromNozzle(machine, {10, 20, 30}).translation().isApprox(Point3(10, 20, 30)));
}

TEST(CartesianMachine, LargeGantriesReachOverTheirBedWithANozzleTiltedEitherWay) {
  for (const auto& [name, back] : {std::pair<std::string, double>{"large_gantry_45", 1.0},
                                   std::pair<std::string, double>{"large_gantry_45_reverse", -1.0}}) {
    const CartesianMachine machine = machineByName(name);
    EXPECT_TRUE(boundingBox(buildSpaceOf(machine)).low.isZero(1e-9)) << name;
    EXPECT_TRUE(boundingBox(buildSpaceOf(machine)).high.isApprox(Point3(1300, 2500, 1000))) << name;
    const Eigen::Isometry3d bed_from_nozzle = bedFromNozzle(machine, {100, 200, 300});
    EXPECT_TRUE(bed_from_nozzle.translation().isApprox(Point3(100, 200, 300))) << name;
    EXPECT_TRUE(bed_from_nozzle.linear().col(2).isApprox(Point3(0, back * M_SQRT1_2, -M_SQRT1_2), 1e-9))
        << name;
    EXPECT_TRUE(programFromBed(machine).matrix().isIdentity(0.0)) << name;
  }
}

TEST(CartesianMachine, TableOfTheDropPrinterMovesBelowItsNozzle) {
  const CartesianMachine machine = machineByName("drop_printer");
  EXPECT_TRUE(bedFromNozzle(machine, {10, 20, 30}).translation().isApprox(Point3(10, 20, 30), 1e-9));
  EXPECT_TRUE(bedFromNozzle(machine, {10, 20, 30}).linear().isApprox(nozzleDown().toRotationMatrix(), 1e-9));
  EXPECT_TRUE(boundingBox(buildSpaceOf(machine)).low.isZero(1e-9));
  EXPECT_TRUE(boundingBox(buildSpaceOf(machine)).high.isApprox(Point3(200, 200, 200)));
  EXPECT_EQ(machine.urdf.find("<child link=\"gantry\"/>"), std::string::npos) << "nothing carries the nozzle";
}

TEST(CartesianMachine, SensorLooksDownBesideTheNozzle) {
  for (const auto& [name, place] : kSensors) {
    const CartesianMachine machine = machineByName(name);
    const Eigen::Isometry3d bed_from_sensor = bedFromNozzle(machine, {0, 0, 0}) * machine.nozzle_from_sensor;
    EXPECT_TRUE(bed_from_sensor.translation().isApprox(place, 1e-9)) << name;
    EXPECT_TRUE(bed_from_sensor.linear().col(2).isApprox(-Point3::UnitZ(), 1e-9)) << name;
  }
}

TEST(CartesianMachine, InverseAnswersForward) {
  EXPECT_TRUE(rc::check("axis values come back from the pose they give", [](std::uint64_t seed) {
    Random random(seed);
    for (const std::string& name : machineNames()) {
      const CartesianMachine machine = machineByName(name);
      AxisValues values;
      for (int i = 0; i < 3; ++i) {
        const MachineAxis& axis = machine.axes[static_cast<std::size_t>(i)];
        values[i] = random.uniform(axis.low_mm, axis.high_mm);
      }
      RC_ASSERT((axisValues(machine, bedFromNozzle(machine, values).translation()) - values).norm() < 1e-9);
    }
  }));
}

TEST(CartesianMachine, BedThatMovesCountsAgainstTheNozzle) {
  // The gantry stands, the bed moves back: the nozzle moves to the front over the bed.
  std::string text =
      gantryWith("<joint name=\"base_to_bed\" type=\"fixed\">", "<joint name=\"y\" type=\"prismatic\">");
  const std::string old_y =
      "<joint name=\"y\" type=\"prismatic\">\n    <parent link=\"base_link\"/>\n    <child link=\"gantry\"/>";
  const std::string limits =
      "<axis xyz=\"0 1 0\"/><limit lower=\"-0.22\" upper=\"0\" velocity=\"1\" effort=\"1\"/>";
  text.replace(
      text.find(old_y), old_y.size(),
      "<joint name=\"base_to_gantry\" type=\"fixed\"><parent link=\"base_link\"/><child link=\"gantry\"/>");
  text.insert(text.find("<child link=\"bed\"/>"), limits);
  const CartesianMachine machine = machineFromUrdf(text);
  EXPECT_TRUE(bedFromNozzle(machine, {10, -20, 30}).translation().isApprox(Point3(10, 20, 30), 1e-9));
}

TEST(CartesianMachine, OfFiveAxesIsThatOfItsLinearOnesWithTheOthersAtZero) {
  for (const std::string& name : machineNames()) {
    const CartesianMachine machine = machineByName(name);
    if (machine.rotary_joints.empty()) continue;
    EXPECT_TRUE(bedFromNozzle(machine, {10, 20, 30}).translation().isApprox(Point3(10, 20, 30), 1e-9))
        << name;
    EXPECT_TRUE(
        bedFromNozzle(machine, {10, 20, 30}).linear().isApprox(nozzleDown().toRotationMatrix(), 1e-9));
    const bool has_turntable = name.find("_head_a") == std::string::npos && name != "five_axis_head_bc";
    const Point2 middle = has_turntable ? Point2(0, 0) : Point2(150, 150);
    EXPECT_TRUE(boundingBox(buildSpaceOf(machine)).centre().head<2>().isApprox(middle, 1e-9)) << name;
  }
  EXPECT_EQ(machineByName("five_axis_table_ac").rotary_joints, (std::vector<std::string>{"c", "a"}));
  EXPECT_TRUE(machineByName("gantry_45").rotary_joints.empty());
}

TEST(CartesianMachine, RefusesAnUnknownNameAndListsTheKnown) {
  try {
    machineByName("delta");
    FAIL() << "an unknown machine was found";
  } catch (const InvalidConfig& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind("machine.name is 'delta'; must be one of belt_45, cartesian_gantry", 0), 0U);
    for (const std::string& name : machineNames()) EXPECT_NE(message.find(name), std::string::npos) << name;
  }
}

TEST(CartesianMachine, RefusesArmsAndPlatformsByName) {
  const std::vector<std::pair<std::string, std::string>> robots = {
      {"irb_4400", "arm"}, {"irb_4600", "arm"}, {"irb_4600_turntable", "arm"}, {"rus_platform", "platform"}};
  for (const auto& [name, kind] : robots) {
    const std::string expected =
        "machine '" + name + "' is a robot (" + kind +
        ") without linear axes x, y and z; expected one of belt_45, cartesian_gantry, drop_printer";
    EXPECT_EQ(refusalOfMachine({name, ""}).rfind(expected, 0), 0U) << refusalOfMachine({name, ""});
    const std::string file = std::string(LAMINA_SOURCE_DIR) + "/urdf/" + name + ".urdf";
    EXPECT_EQ(refusalOfMachine({"cartesian_gantry", file}), refusalOfMachine({name, ""}));
  }
  EXPECT_EQ(refusalOfMachine({"five_axis_head_ac", ""}), "");
}

TEST(CartesianMachine, RefusesDescriptionsThatAreNoSuchMachine) {
  EXPECT_THROW(machineFromUrdf("not xml"), InvalidConfig);
  EXPECT_THROW(machineFromUrdf(gantryWith("name=\"sensor\"", "name=\"eye\"")), InvalidConfig);
  EXPECT_THROW(machineFromUrdf(gantryWith("type=\"prismatic\"", "type=\"revolute\"")), InvalidConfig);
  EXPECT_THROW(machineFromUrdf(gantryWith("<axis xyz=\"0 0 1\"/>", "<axis xyz=\"1 0 0\"/>")), InvalidConfig);
  EXPECT_THROW(machineFromUrdf(gantryWith("<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 2\"/>")), InvalidConfig);
}

TEST(CartesianMachine, DescriptionIsTheFileOfItsName) {
  for (const std::string& name : kinematicModelNames())
    EXPECT_EQ(kinematicModelByName(name)->urdf(),
              readFile(std::string(LAMINA_SOURCE_DIR) + "/urdf/" + name + ".urdf"));
  EXPECT_EQ(machineByName("gantry_45").urdf, kinematicModelByName("gantry_45")->urdf());
}

}  // namespace
}  // namespace lamina
