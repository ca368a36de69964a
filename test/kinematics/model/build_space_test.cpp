// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/build_space.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

// Figures in these tests are those of urdf/, in mm; a URDF's numbers have 15 digits.
constexpr double kWithin = 1e-9;
constexpr double kBelt = 1e6;                        // mm
constexpr double kGantryOfBelt = 250.0 * M_SQRT1_2;  // up the incline of 45 deg and along the belt

void expectBox(const BuildSpace& space, const Point3& low, const Point3& high) {
  const Box3 box = boundingBox(space);
  EXPECT_LT((box.low - low).norm(), kWithin) << space.name << ": " << box.low.transpose();
  EXPECT_LT((box.high - high).norm(), kWithin) << space.name << ": " << box.high.transpose();
}

/// Whether the space is spoken of in coordinates of the bed, as it is by all but belts.
bool isOfBed(const BuildSpace& space) {
  return space.program_from_bed.matrix() == Eigen::Matrix4d::Identity() &&
         space.is_endless == std::array<bool, 3>{};
}

std::string buildSpaceFailure(const std::string& text) {
  try {
    buildSpaceFromUrdf(text);
    return "";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

/// The text of a robot with one part of it replaced.
std::string robotWith(const std::string& name, const std::string& what, const std::string& by) {
  std::string text = kinematicModelByName(name)->urdf();
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(BuildSpace, OfAGantryIsWhatItsAxesReachOverItsPlate) {
  const BuildSpace space = buildSpaceByName("cartesian_gantry");
  EXPECT_EQ(space.name, "cartesian_gantry");
  expectBox(space, {0, 0, 0}, {220, 220, 250});
  EXPECT_TRUE(toolAxis(space).isApprox(Point3(0, 0, -1), kWithin));
  EXPECT_TRUE(isOfBed(space));
  EXPECT_FALSE(canTurnToolAxis(space));
  EXPECT_TRUE(space.tip_from_sensor->translation().isApprox(Point3(25, 0, 60), kWithin));
  EXPECT_TRUE(sensorOffset(space).isApprox(Point2(25, 0), kWithin));
}

TEST(BuildSpace, OfAGantryAt45DegreesHasItsNozzleTiltedOverTheSameRoom) {
  const BuildSpace space = buildSpaceByName("gantry_45");
  expectBox(space, {0, 0, 0}, {220, 220, 250});
  EXPECT_TRUE(toolAxis(space).isApprox(Point3(0, M_SQRT1_2, -M_SQRT1_2), kWithin));
  EXPECT_TRUE(isOfBed(space));
  EXPECT_FALSE(canTurnToolAxis(space));
  EXPECT_TRUE(sensorOffset(space).isApprox(Point2(25, 0), kWithin)) << "the sensor looks straight down";
}

TEST(BuildSpace, ASensorMeetsTheLevelOfTheNozzleStraightBelowItself) {
  EXPECT_TRUE(sensorOffset(buildSpaceByName("drop_printer")).isApprox(Point2(25, 0), kWithin));
  for (const std::string name : {"large_gantry_45", "large_gantry_45_reverse"}) {
    const BuildSpace space = buildSpaceByName(name);
    EXPECT_TRUE(space.tip_from_sensor->translation().isApprox(Point3(150, 0, 250), kWithin)) << name;
    EXPECT_TRUE(sensorOffset(space).isApprox(Point2(150, 0), kWithin)) << name;
  }
  BuildSpace upwards = buildSpaceByName("cartesian_gantry");
  upwards.tip_from_sensor = Eigen::Isometry3d::Identity();
  EXPECT_THROW(sensorOffset(upwards), InvalidConfig);
}

TEST(BuildSpace, AnUprightHeadKeepsTipsAndSensorWhereTheyWere) {
  const BuildSpace inclined = buildSpaceByName("gantry_45");
  const BuildSpace upright = withUprightHead(inclined);
  EXPECT_TRUE(toolAxis(upright).isApprox(Point3(0, 0, -1), kWithin));
  expectBox(upright, {0, 0, 0}, {220, 220, 250});
  EXPECT_EQ(sensorOffset(upright), sensorOffset(inclined));
}

TEST(BuildSpace, OfABeltIsEndlessAlongItAndSpokenOfInAxisValues) {
  const BuildSpace space = buildSpaceByName("belt_45");
  expectBox(space, {0, -kBelt, 0}, {300, kGantryOfBelt, kGantryOfBelt});
  EXPECT_EQ(space.is_endless, (std::array<bool, 3>{false, false, true}));
  EXPECT_TRUE(space.bed_from_axes.linear().col(2).isApprox(Point3(0, -1, 0), kWithin));
  EXPECT_TRUE(toolAxis(space).isApprox(Point3(0, M_SQRT1_2, -M_SQRT1_2), kWithin));
  EXPECT_FALSE(canTurnToolAxis(space));
  // 5 mm over the belt is 5 / sin 45 deg up the incline, whose foot is then 5 mm behind.
  EXPECT_TRUE((space.program_from_bed * Point3(12, -7, 5)).isApprox(Point3(12, 5 * M_SQRT2, 12), kWithin));
  EXPECT_TRUE(sensorOffset(space).isApprox(Point2(25, 0), kWithin)) << "it looks along the tool axis";
  const Eigen::Quaterniond inclined(Eigen::AngleAxisd(0.25 * M_PI, Point3::UnitX()));
  EXPECT_TRUE(sensorOffset(space, inclined).isApprox(Point2(25, 0), kWithin))
      << "and square to layers at 45 deg";
}

TEST(BuildSpace, OfFiveAxesIsThatOfTheLinearOnesWithAToolAxisThatCanTurn) {
  const BuildSpace space = buildSpaceByName("five_axis_head_table");
  expectBox(space, {-300, -170, -100}, {300, 170, 350});
  EXPECT_TRUE(toolAxis(space).isApprox(Point3(0, 0, -1), kWithin));
  EXPECT_TRUE(isOfBed(space));
  EXPECT_TRUE(canTurnToolAxis(space));
  EXPECT_EQ(space.rotary_joints, (std::vector<std::string>{"c", "b"}));
}

TEST(BuildSpace, OfARobotIsTheRoomOverTheBodiesOfItsBed) {
  expectBox(buildSpaceByName("irb_4600"), {-400, -400, 0}, {400, 400, 1500});
  expectBox(buildSpaceByName("irb_4600_turntable"), {-350, -350, 0}, {350, 350, 1500});
  expectBox(buildSpaceByName("rus_platform"), {0, 0, 0}, {120, 120, 1500});
  const BuildSpace space = buildSpaceByName("irb_4600");
  EXPECT_EQ(space.name, "irb_4600");
  EXPECT_TRUE(toolAxis(space).isApprox(Point3(0, 0, -1), kWithin));
  EXPECT_TRUE(isOfBed(space));
  EXPECT_TRUE(canTurnToolAxis(space));
  EXPECT_EQ(space.rotary_joints,
            (std::vector<std::string>{"joint_1", "joint_2", "joint_3", "joint_4", "joint_5", "joint_6"}));
  EXPECT_FALSE(space.tip_from_sensor);
  EXPECT_EQ(sensorOffset(space), Point2(0, 0));
}

TEST(BuildSpace, OfABedTurnedOnItsLinkIsTheBoxOfItsBodies) {
  const std::string plate =
      "<collision>\n      <origin xyz=\"0 0 -0.015\"/>\n      <geometry><box size=\"0.8 ";
  // Turned by a quarter, and 100 mm along x; the leg below it is 600 mm wide.
  const std::string turned =
      "<collision>\n      <origin xyz=\"0.1 0 -0.015\" rpy=\"0 0 1.5707963267948966\"/>\n"
      "      <geometry><box size=\"0.2 ";
  expectBox(buildSpaceFromUrdf(robotWith("irb_4600", plate, turned)), {-300, -300, 0}, {500, 300, 1500});
}

TEST(BuildSpace, SettingsChooseItByNameOrByFile) {
  const test::ScratchFolder folder;
  writeFile(folder.file("cell.urdf"), kinematicModelByName("irb_4400")->urdf());
  EXPECT_EQ(buildSpaceOf(MachineSettings{"irb_4600", ""}).name, "irb_4600");
  EXPECT_EQ(buildSpaceOf(MachineSettings{"irb_4600", folder.file("cell.urdf")}).name, "irb_4400");
}

TEST(BuildSpace, RefusesWhatHasNone) {
  EXPECT_NE(buildSpaceFailure("not xml").find("is no URDF"), std::string::npos);
  std::string bedless = kinematicModelByName("irb_4600")->urdf();
  for (const std::string named : {"link name=\"bed\"", "child link=\"bed\""})
    bedless.replace(bedless.find(named) + named.size() - 4, 4, "top\"");
  EXPECT_EQ(buildSpaceFailure(bedless), "machine 'irb_4600' has no link 'bed'");
  std::string bare = kinematicModelByName("rus_platform")->urdf();
  const std::size_t bed = bare.find("<link name=\"bed\">");
  const std::size_t body = bare.find("<collision>", bed);
  const std::string end = "</collision>";
  bare.erase(body, bare.find(end, body) + end.size() - body);
  EXPECT_EQ(
      buildSpaceFailure(bare),
      "machine 'rus_platform': link 'bed' has no collision body; expected one of the size of the plate");
  try {
    buildSpaceByName("delta");
    FAIL() << "an unknown machine was found";
  } catch (const InvalidConfig& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind("machine.name is 'delta'; must be one of belt_45, cartesian_gantry", 0), 0U);
    for (const std::string& name : kinematicModelNames())
      EXPECT_NE(message.find(name), std::string::npos) << name;
  }
}

TEST(BuildSpace, IsWhatAxisValuesWithinTheLimitsGive) {
  for (const std::string& name : machineNames()) {
    const CartesianMachine machine = machineByName(name);
    const BuildSpace space = buildSpaceOf(machine);
    const AxisValues values(12.0, 34.0, 56.0);
    const Eigen::Isometry3d nozzle = bedFromNozzle(machine, values);
    EXPECT_TRUE((space.bed_from_axes * values).isApprox(nozzle.translation(), 1e-12)) << name;
    EXPECT_TRUE(toolAxis(space).isApprox(nozzle.linear().col(2), 1e-12)) << name;
    EXPECT_EQ(space.program_from_bed.matrix(), programFromBed(machine).matrix()) << name;
  }
}

}  // namespace
}  // namespace lamina
