// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {
namespace {

/// Of the machines whose sensor looks straight down: its place over the nozzle.
const std::vector<std::pair<std::string, Point3>> kSensors = {{"cartesian_gantry", {25, 0, 60}},
                                                              {"drop_printer", {25, 0, 60}},
                                                              {"gantry_45", {25, 0, 60}},
                                                              {"large_gantry_45", {150, 0, 250}},
                                                              {"large_gantry_45_reverse", {150, 0, 250}}};

/// A toolpath of one travel through these points, nozzle straight down.
Toolpath through(const std::vector<Point3>& points) {
  Path path;
  path.role = PathRole::Travel;
  path.points = points;
  path.feed_mm_s = 100.0;
  Toolpath toolpath;
  toolpath.layers.push_back({points[0].z(), 0.2, {path}});
  return toolpath;
}

std::string unreachable(const Toolpath& toolpath, const CartesianMachine& machine) {
  try {
    requireReachable(toolpath, Eigen::Isometry3d::Identity(), machine);
    return "";
  } catch (const Unreachable& error) {
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
  EXPECT_TRUE(workspace(machine).low.isZero(1e-9));
  EXPECT_TRUE(workspace(machine).high.isApprox(Point3(220, 220, 250)));
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
    EXPECT_TRUE(workspace(machine).low.isZero(1e-9)) << name;
    EXPECT_TRUE(workspace(machine).high.isApprox(Point3(1300, 2500, 1000))) << name;
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
  EXPECT_TRUE(workspace(machine).low.isZero(1e-9));
  EXPECT_TRUE(workspace(machine).high.isApprox(Point3(200, 200, 200)));
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
      RC_ASSERT((axisValuesWithin(machine, bedFromNozzle(machine, values)) - values).norm() < 1e-9);
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

TEST(CartesianMachine, NamesTheFirstWaypointOutOfReach) {
  const CartesianMachine machine = machineByName("cartesian_gantry");
  EXPECT_EQ(unreachable(through({{0, 0, 0}, {220, 220, 250}}), machine), "");
  EXPECT_EQ(unreachable(through({{0, 0, 0}, {0, 230.5, 0}, {-1, 0, 0}}), machine),
            "layer 0, path 0, waypoint 1: axis y would be at 230.500 mm; cartesian_gantry reaches 0.000 to "
            "220.000 mm");
  EXPECT_NE(unreachable(through({{0, 0, 0}, {0, 0, std::nan("")}}), machine), "");
}

TEST(CartesianMachine, RefusesAnotherAngleOfTheNozzle) {
  EXPECT_EQ(unreachable(through({{0, 0, 0}, {10, 10, 10}}), machineByName("gantry_45")),
            "layer 0, path 0, waypoint 0: the nozzle would have to turn by 45.000 deg; the head of gantry_45 "
            "is fixed");
}

TEST(CartesianMachine, LetsTheNozzleTurnAboutItsToolAxis) {
  const CartesianMachine machine = machineByName("cartesian_gantry");
  const Eigen::Isometry3d turned =
      bedFromNozzle(machine, {1, 2, 3}) * Eigen::Isometry3d(Eigen::AngleAxisd(1.0, Point3::UnitZ()));
  EXPECT_TRUE(axisValuesWithin(machine, turned).isApprox(AxisValues(1, 2, 3)));
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
    EXPECT_TRUE(workspace(machine).centre().head<2>().isApprox(middle, 1e-9)) << name;
  }
  EXPECT_EQ(machineByName("five_axis_table_ac").rotary_joints, (std::vector<std::string>{"c", "a"}));
  EXPECT_TRUE(machineByName("gantry_45").rotary_joints.empty());
}

TEST(CartesianMachine, RefusesToTiltItsNozzleByItsLinearAxesAlone) {
  Toolpath tilted = through({{0, 0, 0}, {10, 10, 10}});
  tilted.layers[0].paths[0].orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.75 * M_PI, Point3::UnitX()));
  EXPECT_EQ(unreachable(tilted, machineByName("five_axis_head_table")),
            "layer 0, path 0, waypoint 0: the nozzle would have to turn by 45.000 deg; the linear axes of "
            "five_axis_head_table alone hold it as it is with joints c and b at zero");
}

TEST(CartesianMachine, RefusesAnUnknownNameAndListsTheKnown) {
  try {
    machineByName("delta");
    FAIL() << "an unknown machine was found";
  } catch (const InvalidConfig& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind("machine.name is 'delta'; must be one of belt_45, cartesian_gantry", 0), 0U);
    for (const std::string& name : kinematicModelNames())
      EXPECT_NE(message.find(name), std::string::npos) << name;
  }
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
    EXPECT_EQ(machineByName(name).urdf, readFile(std::string(LAMINA_SOURCE_DIR) + "/urdf/" + name + ".urdf"));
}

TEST(CartesianMachine, TheSensorMeetsTheLevelOfTheNozzleStraightBelowItself) {
  for (const auto& [name, place] : kSensors) {
    const Point2 offset = sensorOffset(machineByName(name));
    EXPECT_NEAR(offset.x(), place.x(), 1e-6) << name;
    EXPECT_NEAR(offset.y(), 0.0, 1e-6) << name;
  }
}

}  // namespace
}  // namespace lamina
