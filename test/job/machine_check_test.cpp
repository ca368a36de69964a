// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/machine_check.hpp"

#include <gtest/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/clear_approach.hpp"
#include "lamina/job/program_check.hpp"
#include "support/scratch_folder.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using Eigen::Isometry3d;

MachineCheck checkOn(const std::string& machine, const Toolpath& toolpath, const Point3& place) {
  const auto model = kinematicModelByName(machine);
  NoProgress nobody;
  const KinematicModelRun run = runOn(*model, toolpath, Isometry3d(Eigen::Translation3d(place)), {}, nobody);
  return checkRun(run, *model, {}, nobody);
}

/// A closed square of 100 mm, whose sides are divided into steps.
Toolpath square() {
  Path wall = test::straightPath({0, 0, 0.2}, {100, 0, 0.2});
  wall.is_closed = true;
  wall.points.insert(wall.points.end(), {{100, 100, 0.2}, {0, 100, 0.2}});
  return {"square", {{0.2, 0.2, {wall}}}};
}

/// A travel down from 50 mm over the bed's middle.
Toolpath travelDownTo(double height) {
  Path travel = test::straightPath({0, 0, 50}, {0, 0, height});
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  return {"travel", {{0.2, 0.2, {travel}}}};
}

std::string refusal(const MachineCheck& check, const std::string& machine) {
  try {
    requireClear(check, *kinematicModelByName(machine));
  } catch (const Unreachable& error) {
    return error.what();
  }
  return "";
}

TEST(MachineCheck, IsClearWhereTheMachineRunsAll) {
  for (const char* machine : {"five_axis_head_ac", "irb_4600", "cartesian_gantry"}) {
    const MachineCheck check = checkOn(machine, square(), {60, 60, 0});
    EXPECT_TRUE(check.isClear()) << machine;
    EXPECT_EQ(check.waypoints, 4U);
    EXPECT_EQ(refusal(check, machine), "");
  }
}

TEST(MachineSheet, TellsMachinesOfOneNameApart) {
  const test::ScratchFolder folder;
  const std::string path = std::string(LAMINA_SOURCE_DIR) + "/urdf/cartesian_gantry.urdf";
  std::string smaller = readTextFile(path);
  const std::string range = R"(lower="0" upper="0.25")";  // of z, the only one
  ASSERT_NE(smaller.find(range), std::string::npos);
  smaller.replace(smaller.find(range), range.size(), R"(lower="0" upper="0.15")");
  writeFile(folder.file("gantry.urdf"), smaller);
  const std::string built_in = machineSheet({"cartesian_gantry", ""});
  EXPECT_NE(built_in.find("machine: cartesian_gantry\ndescription: built in\n"), std::string::npos)
      << built_in;
  EXPECT_NE(built_in.find("reach in x: 0 to 220 mm\nreach in y: 0 to 220 mm\nreach in z: 0 to 250 mm\n"),
            std::string::npos)
      << built_in;
  const std::string other = machineSheet({"cartesian_gantry", folder.file("gantry.urdf")});
  EXPECT_NE(other.find("reach in z: 0 to 150 mm\n"), std::string::npos) << other;
  EXPECT_NE(other.find("description: SHA-256 "), std::string::npos) << other;
  EXPECT_NE(machineSheet({"cartesian_gantry", path}), other);
}

TEST(MachineCheck, NamesEachWaypointOfAClosedPathOnce) {
  const MachineCheck check = checkOn("five_axis_head_ac", square(), {1e5, 60, 0});
  EXPECT_EQ(check.waypoints, 4U);
  ASSERT_EQ(check.faults.size(), 4U);
  for (std::size_t w = 0; w < 4; ++w) {
    EXPECT_EQ(check.faults[w].at.waypoint, w);
    EXPECT_EQ(check.faults[w].what, "out_of_limits");
  }
  EXPECT_TRUE(check.faults[0].tip.isApprox(Point3(0, 0, 0.2)));
  EXPECT_NE(refusal(check, "five_axis_head_ac").find("five_axis_head_ac cannot run 4 waypoints)"),
            std::string::npos);
  MachineCheck colliding = check;
  colliding.collisions = {check.faults[0]};
  EXPECT_NE(
      refusal(colliding, "five_axis_head_ac").find(" cannot run 4 waypoints and collides at 1 waypoint)"),
      std::string::npos);
  colliding.faults.clear();
  EXPECT_NE(refusal(colliding, "five_axis_head_ac").find("five_axis_head_ac collides at 1 waypoint)"),
            std::string::npos);
}

TEST(MachineCheck, NamesWhyABeltCannotRunIt) {
  Toolpath toolpath = square();
  const MachineCheck level = checkOn("belt_45", toolpath, {20, 50, 0});
  ASSERT_FALSE(level.faults.empty());
  EXPECT_EQ(level.faults[0].what, "out_of_reach");
  EXPECT_NE(level.faults[0].reason.find("45 deg off the tool axis"), std::string::npos)
      << level.faults[0].reason;

  // Along the endless belt it is out of a limit all the same: the axis begins at 0.
  const auto belt = kinematicModelByName("belt_45");
  toolpath.layers[0].paths[0].orientation =
      Eigen::Quaterniond(belt->bedFromNozzle(JointValues::Zero(3)).linear());
  const MachineCheck behind = checkOn("belt_45", toolpath, {20, 500, 0});
  ASSERT_FALSE(behind.faults.empty());
  EXPECT_EQ(behind.faults[0].what, "out_of_limits") << behind.faults[0].reason;
}

TEST(MachineCheck, NamesANozzleInTheBedOnceWhateverTheStepsOfItsMotion) {
  EXPECT_TRUE(checkOn("irb_4600", travelDownTo(5.0), {0, 0, 0}).isClear());
  const MachineCheck check = checkOn("irb_4600", travelDownTo(-25.0), {0, 0, 0});
  EXPECT_TRUE(check.faults.empty());
  ASSERT_EQ(check.collisions.size(), 1U);
  EXPECT_EQ(check.collisions[0].at.waypoint, 1U);
  EXPECT_EQ(check.collisions[0].what, "collision");
  EXPECT_EQ(check.collisions[0].reason, "link 'nozzle' is in the bed");
  EXPECT_LT(check.collisions[0].tip.z(), 0.0);
}

// Down through the bed in layer 0, and once more in layer 1.
TEST(MachineCheck, SaysWhichLinkMeetsWhatHowOftenAndFromWhichLayerOn) {
  Toolpath dives = travelDownTo(5.0);
  dives.layers.push_back(travelDownTo(-25.0).layers[0]);
  dives.layers.push_back(dives.layers[1]);
  const MachineCheck check = checkOn("irb_4600", dives, {0, 0, 0});
  ASSERT_TRUE(check.faults.empty());
  ASSERT_FALSE(check.collisions.empty());
  for (const Finding& finding : check.collisions) EXPECT_EQ(finding.meeting, "link 'nozzle' in the bed");
  const std::string count = std::to_string(check.collisions.size());
  EXPECT_NE(refusal(check, "irb_4600")
                .find("waypoints): link 'nozzle' in the bed at " + count + " waypoints from layer 1 on"),
            std::string::npos)
      << refusal(check, "irb_4600");
}

TEST(MachineCheck, NamesTheThreeMostFrequentPairs) {
  MachineCheck check;
  const auto add = [&](std::size_t layer, const char* meeting) {
    check.collisions.push_back({{layer, 0, 0}, Point3::Zero(), "collision", "reason", 0, meeting});
  };
  add(4, "a in b");
  for (std::size_t layer : {5, 6, 7}) add(layer, "c in d");
  for (std::size_t layer : {8, 9}) add(layer, "e in f");
  add(9, "g in h");
  EXPECT_NE(refusal(check, "irb_4600")
                .find("irb_4600 collides at 7 waypoints): c in d at 3 waypoints from layer 5 on, e in f at 2 "
                      "waypoints from layer 8 on, a in b at 1 waypoint from layer 4 on, and 1 more pair"),
            std::string::npos)
      << refusal(check, "irb_4600");
}

TEST(MachineCheck, CountsCollidingWaypointsAndShowsTheFirstOfEachLayer) {
  const auto arm = kinematicModelByName("irb_4600");
  Toolpath dives = travelDownTo(-25.0);
  dives.layers.push_back(dives.layers[0]);
  dives.layers[1].paths.push_back(dives.layers[0].paths[0]);
  NoProgress nobody;
  const KinematicModelRun run = runOn(*arm, dives, Isometry3d::Identity(), {}, nobody);
  const ClearanceReport report = clearanceOf(run, CheckedMachine(*arm), {}, nobody);
  EXPECT_EQ(report.waypoints, 6U);
  EXPECT_EQ(report.colliding, checkRun(run, *arm, {}, nobody).collisions.size());
  ASSERT_EQ(report.first_of_layers.size(), 2U);
  EXPECT_EQ(report.first_of_layers[0].at, (WaypointIndex{0, 0, 1}));
  EXPECT_EQ(report.first_of_layers[1].at.layer, 1U);
  EXPECT_EQ(report.first_of_layers[0].link, "nozzle");
  EXPECT_EQ(report.first_of_layers[0].obstacle, Obstacle::Bed);
}

std::string printableRefusal(const std::string& program, const std::string& machine) {
  const test::ScratchFolder folder;
  writeFile(folder.file("part.gcode"), program);
  MachineSettings settings;
  settings.name = machine;
  try {
    requirePrintable(folder.file("part.gcode"), settings);
  } catch (const Unreachable& error) {
    return error.what();
  }
  return "";
}

TEST(PrintableProgram, KeepsToTheBoundedAxesOfABelt) {
  const BuildSpace space = buildSpaceByName("belt_45");
  ASSERT_TRUE(space.is_endless[2]);
  const Point3 high = space.range.high;
  const auto programTo = [](double x, double y, double z) {
    return "M83\nG1 X10 Y10 Z10 F600\nG1 X" + std::to_string(x) + " Y" + std::to_string(y) + " Z" +
           std::to_string(z) + " E1\n";
  };
  EXPECT_EQ(printableRefusal(programTo(high.x(), high.y(), 1e5), "belt_45"), "") << "the belt has no end";
  EXPECT_NE(printableRefusal(programTo(high.x() + 1.0, 10.0, 10.0), "belt_45").find("axis x would be at"),
            std::string::npos);
  EXPECT_NE(printableRefusal(programTo(10.0, high.y() + 1.0, 10.0), "belt_45").find("axis y would be at"),
            std::string::npos);
  EXPECT_NE(
      printableRefusal(programTo(10.0, 10.0, space.range.low.z() - 1.0), "belt_45").find("line 3 extrudes"),
      std::string::npos);
}

TEST(ClearApproach, RefusesALiftOfMoreThanAMetre) {
  const auto model = kinematicModelByName("cartesian_gantry");
  ApproachDemands demands;
  demands.way.lift_mm = 1001.0;
  NoProgress nobody;
  const JointValues from = JointValues::Zero(3);
  try {
    clearApproach(from, JointValues::Constant(3, 10.0), *model, demands, nobody);
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_STREQ(error.what(), "approach.lift_mm is 1001 mm; expected at most 1000 mm");
  }
}

}  // namespace
}  // namespace lamina
