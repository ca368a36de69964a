// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Ways to the part, away from it and between the files of a program are judged as they stand in it.
#include "lamina/job/passages/run_passages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/run_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

/// Over the table, out of the head's way while it prints.
constexpr char kShelf[] =
    "<link name=\"shelf\"><collision><origin xyz=\"1.45 0 1.3\"/><geometry><box size=\"0.1 "
    "0.4 0.02\"/></geometry></collision></link><joint name=\"shelf_on_base\" type=\"fixed\"><parent "
    "link=\"base_link\"/><child link=\"shelf\"/></joint>";

/// A small box and its program for the arm.
class RunPassages : public testing::Test {
 protected:
  RunPassages() {
    job_.part = folder_.file("box.stl");
    job_.settings.slicing.layer_height_mm = 0.5;
    job_.settings.slicing.first_layer_height_mm = 0.5;
    job_.settings.planning.skirt.count = 0;
    job_.settings.machine.name = "irb_4600";
    writeStl(job_.part, test::boxBetween({0, 0, 0}, {12, 8, 1}));
  }

  void slice(const std::string& output) {
    job_.output = folder_.file(output);
    runSliceJob(job_, nobody_);
  }

  /// Replaces what stands from the first `begin` of a file on up to its `end`.
  /// @return number of the line, 1 based
  std::size_t edit(const std::string& file, const std::string& begin, const std::string& end,
                   const std::string& text) {
    std::string program = readFile(folder_.file(file));
    const std::size_t at = program.find(begin);
    if (at == std::string::npos) throw InvalidInput("no '" + begin + "' in " + file);
    program.replace(at, program.find(end, at) - at, text);
    writeFile(folder_.file(file), program);
    return 1 + static_cast<std::size_t>(
                   std::count(program.begin(), program.begin() + static_cast<long>(at), '\n'));
  }

  MachineCheck checked() {
    const auto model = kinematicModelOf(job_.settings.machine);
    auto stated = readStatedMotion(job_.output, job_.settings.program, *model);
    return checkRun(runAsStated(*model, std::move(*stated), job_.settings.joints), *model,
                    job_.settings.clearance, nobody_);
  }

  static const Finding* atLine(const std::vector<Finding>& findings, std::size_t line) {
    for (const Finding& finding : findings)
      if (finding.line == line) return &finding;
    return nullptr;
  }

  test::ScratchFolder folder_;
  SliceJob job_;
  NoProgress nobody_;
};

TEST_F(RunPassages, AreFreeAsWrittenInEveryLanguage) {
  for (const char* file : {"box.mod", "box.src", "box.script", "box.ls", "box.jbi"}) {
    slice(file);
    const MachineCheck check = checked();
    EXPECT_TRUE(check.isClear()) << file;
    EXPECT_NE(check.unknown_way.find("the program begins wherever the arm stands"), std::string::npos)
        << file;
  }
}

/// With axis 2 at 110 deg the upper arm lies below the table's top.
TEST_F(RunPassages, JointsThatAreInTheTableAreFoundByTheirLine) {
  slice("box.src");
  const std::size_t line = edit("box.src", "PTP {A1", "\n",
                                "PTP {A1 0.0000,A2 110.0000,A3 10.0000,A4 0.0000,A5 60.0000,A6 0.0000}");
  const MachineCheck check = checked();
  EXPECT_FALSE(check.isClear());
  const Finding* finding = atLine(check.collisions, line);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->reason.find("on the way to the part: "), 0U) << finding->reason;
}

TEST_F(RunPassages, JointsBeyondTheirLimitAreFoundByTheirLine) {
  slice("box.src");
  const std::size_t line = edit("box.src", "PTP {A1", ",A2", "PTP {A1 181.5");
  const MachineCheck check = checked();
  const Finding* finding = atLine(check.faults, line);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->what, "out_of_limits");
  EXPECT_NE(finding->reason.find("joint_1 at 181.5"), std::string::npos) << finding->reason;
}

TEST_F(RunPassages, ARetractIntoTheTableIsFoundByItsLine) {
  slice("box.mod");
  const std::size_t begin = edit("box.mod", "PROC deposit_end()", "PROC deposit_end()", "");
  const std::string program = readFile(job_.output);
  const std::size_t point = program.find("[[", program.find("PROC deposit_end()"));
  const std::string pose = program.substr(point, program.find(']', point) + 1 - point);
  edit("box.mod", pose, "]", "[[0,0,-300.0");
  const MachineCheck check = checked();
  const Finding* finding = atLine(check.collisions, begin + 1);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->reason.find("on the way from the part: "), 0U) << finding->reason;
}

/// From a quarter turn to one side of the table to a quarter turn to its other side joint 1 sweeps the arm,
/// low enough for the head to pass through the table, which both ends stand clear of.
TEST_F(RunPassages, JointsBetweenTwoScriptsAreLedAsJoints) {
  job_.settings.program.robot.urscript.max_points = 300;
  slice("box.script");
  ASSERT_TRUE(checked().isClear());
  const std::size_t line = edit("box_2.script", "movej([", "], a=", "movej([1.3, 1.4, 0.3, 0.0, 0.6, 0.0");
  const MachineCheck check = checked();
  const Finding* finding = atLine(check.collisions, line);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->reason.find("on a way between two runs: "), 0U) << finding->reason;
}

TEST_F(RunPassages, StraightWaysAreLedStraightAndJointMovesAreNot) {
  const auto model = kinematicModelOf(job_.settings.machine);
  JointValues start(6);
  start << 0.1, 0.2, 0.3, 0.2, 0.7, 0.1;
  JointValues joined(6);
  joined << 0.3, 0.25, 0.35, 0.3, 0.6, 0.2;
  JointValues end(6);
  end << 0.1, 0.3, 0.2, 0.25, 0.8, 0.1;
  StatedMotion motion;
  motion.between = StatedMove::Nozzle;
  motion.joints.values = {end};
  motion.lines = {9};
  motion.passages = {{0, {{start, StatedMove::Joints, 5, ""}, {joined, StatedMove::Joints, 7, ""}}}};
  const std::vector<RunPassage> led = ledPassages(*model, motion, {});
  ASSERT_EQ(led.size(), 1U);
  const std::vector<JointValues>& values = led[0].joints.values;
  ASSERT_GT(values.size(), 3U);
  EXPECT_EQ(led[0].lines[1], 7U);
  EXPECT_EQ(led[0].lines.back(), 9U);
  EXPECT_TRUE(led[0].faults.empty());
  EXPECT_LE((values[1] - joined).norm(), 1e-12);  // nothing in between: joints at constant speed
  const Point3 from = model->bedFromNozzle(joined).translation();
  const Point3 way = model->bedFromNozzle(end).translation() - from;
  for (std::size_t i = 2; i < values.size(); ++i) {
    const Point3 off = model->bedFromNozzle(values[i]).translation() - from;
    EXPECT_LE(off.cross(way.normalized()).norm(), 0.02) << i;
  }
}

/// A shelf over the table that the head stays below while it prints, and not 300 mm higher.
TEST_F(RunPassages, AreCheckedBeforeAnythingIsWritten) {
  std::string urdf = readFile("urdf/irb_4600.urdf");
  urdf.insert(urdf.find("</robot>"), kShelf);
  writeFile(folder_.file("shelf.urdf"), urdf);
  job_.settings.machine.urdf = folder_.file("shelf.urdf");
  for (const char* file : {"low.src", "low.mod"}) slice(file);
  job_.settings.program.robot.approach_mm = 300.0;
  job_.settings.program.rapid.approach_mm = 300.0;
  for (const char* file : {"high.src", "high.mod"}) {
    try {
      slice(file);
      ADD_FAILURE() << file;
    } catch (const Unreachable& refusal) {
      const std::string what = refusal.what();
      EXPECT_NE(what.find("the part: link 'nozzle' is in link 'shelf'"), std::string::npos) << what;
      EXPECT_NE(what.find("approach_mm"), std::string::npos) << what;
    }
    EXPECT_FALSE(std::ifstream(folder_.file(file)).good()) << file;
  }
}

/// Back along the tool axis by 40 mm, at 20 mm/s with 1000 mm/s2: 2 s and a ramp of 0.02 s. Joint 1 by 0.5
/// rad with a ramp of 0.2 s, from rest to rest.
TEST_F(RunPassages, TakeTimeFromRestToRest) {
  const auto model = kinematicModelOf(job_.settings.machine);
  JointValues start(6);
  start << 0.1, 0.2, 0.3, 0.2, 0.7, 0.1;
  JointValues turned = start;
  turned[0] += 0.5;
  Eigen::Isometry3d away = model->bedFromNozzle(turned);
  away.translate(Point3(0, 0, -40));
  StatedMotion motion;
  motion.between = StatedMove::Nozzle;
  motion.joints.values = {start};
  motion.lines = {9};
  motion.passages = {{1, {{turned, StatedMove::Joints, 11, ""}}}};
  TimingSettings settings;
  settings.motion.travel_acceleration_mm_s2 = 1000.0;
  settings.trajectory.joint_ramp_s = 0.1;
  const double joints_s = 0.5 / model->joints()[0].max_speed + 0.1;
  EXPECT_NEAR(passageTime(ledPassages(*model, motion, {}), *model, settings), joints_s, 1e-9);
  StatedWay back;
  for (const InverseSolution& each : model->solutions(away, turned))
    if (back.to.size() == 0 || (each.values - turned).norm() < (back.to - turned).norm())
      back.to = each.values;
  back.line = 12;
  back.feed_mm_s = 20.0;
  motion.passages[0].ways.push_back(back);
  EXPECT_NEAR(passageTime(ledPassages(*model, motion, {}), *model, settings), joints_s + 2.02, 1e-3);
}

/// A travel of 100 mm, in whose place joint 1 swings aside and back: 2 s at 50 mm/s and a ramp of 0.05 s,
/// which nobody runs.
TEST_F(RunPassages, ReplaceTheTravelThatTheyLeadBeside) {
  const auto model = kinematicModelOf(job_.settings.machine);
  Toolpath toolpath;
  const auto addPath = [&](PathRole role, double from, double to) {
    Path path;
    path.role = role;
    path.feed_mm_s = 50.0;
    if (role != PathRole::Travel) path.bead = Bead{6.0, 2.0};
    path.orientation = AlongPath<Eigen::Quaterniond>(nozzleDown());
    path.points = {Point3(from, 0, 2), Point3(to, 0, 2)};
    if (toolpath.layers.empty()) toolpath.layers.push_back({2.0, 2.0, {}});
    toolpath.layers[0].paths.push_back(std::move(path));
  };
  addPath(PathRole::OuterWall, 0.0, 20.0);
  addPath(PathRole::Travel, 20.0, 120.0);
  addPath(PathRole::OuterWall, 120.0, 140.0);
  JointPathSettings planning;
  planning.yaw = YawChoice::Held;
  StatedMotion motion;
  motion.toolpath = toolpath;
  motion.between = StatedMove::Nozzle;
  motion.joints = planJointPath(toolpath, Eigen::Isometry3d::Identity(), *model, planning, nobody_);
  std::size_t arrival = 0;
  for (std::size_t i = 0; i < motion.joints.at.size(); ++i) {
    motion.lines.push_back(10 + i);
    if (motion.joints.at[i].path == 1) arrival = i;
  }
  TimingSettings settings;
  settings.motion.travel_acceleration_mm_s2 = 1000.0;
  const TimedRun direct = inTime(runAsStated(*model, motion, planning), *model, settings);
  JointValues aside = motion.joints.values[arrival - 1];
  aside[0] += 0.2;
  motion.passages = {{arrival, {{aside, StatedMove::Joints, 9, ""}}, 50.0}};
  const TimedRun led = inTime(runAsStated(*model, motion, planning), *model, settings);
  const double beside_s = passageTime(led.run.passages, *model, settings);
  EXPECT_GT(beside_s, 2.0);
  EXPECT_NEAR(direct.figures.total_s + beside_s - led.figures.total_s, 2.05, 0.1);
  // 3 s at its beginning are waited either way.
  motion.toolpath.layers[0].paths[1].events = {{0, Dwell{3.0}}};
  const TimedRun waiting = inTime(runAsStated(*model, motion, planning), *model, settings);
  EXPECT_NEAR(waiting.figures.total_s - led.figures.total_s, 3.0, 1e-3);
}

/// 200 mm there and 200 mm back at the feed of travels.
TEST_F(RunPassages, AreCountedInTheTimeThatSlicingAndCheckingState) {
  job_.settings.planning.travel.feed_mm_s = 20.0;
  for (const char* file : {"box.src", "box.mod"}) {
    std::vector<double> times;
    for (const double way_mm : {0.0, 200.0}) {
      job_.settings.program.robot.approach_mm = way_mm;
      job_.settings.program.rapid.approach_mm = way_mm;
      job_.output = folder_.file(file);
      times.push_back(runSliceJob(job_, nobody_).summary.estimated_time_s);
    }
    EXPECT_NEAR(times[1] - times[0], 20.0, 0.1) << file;
    const auto model = kinematicModelOf(job_.settings.machine);
    auto stated = readStatedMotion(job_.output, job_.settings.program, *model);
    const TimedRun timed = inTime(runAsStated(*model, std::move(*stated), job_.settings.joints), *model,
                                  runSettings(job_.settings).timing);
    EXPECT_NEAR(timed.figures.total_s, times[1], 0.02 * times[1]) << file;
  }
}

/// What a choice of the mode cannot mend is said with the modes that were tried.
TEST_F(RunPassages, MakeAutoTryTheNextMode) {
  std::string urdf = readFile("urdf/irb_4600.urdf");
  urdf.insert(urdf.find("</robot>"), kShelf);
  writeFile(folder_.file("shelf.urdf"), urdf);
  job_.settings.machine.urdf = folder_.file("shelf.urdf");
  job_.settings.slicing.mode = "auto";
  job_.settings.program.robot.approach_mm = 300.0;
  try {
    slice("high.src");
    FAIL();
  } catch (const Unreachable& refusal) {
    const std::string what = refusal.what();
    EXPECT_NE(what.find("not planar: "), std::string::npos) << what;
    EXPECT_NE(what.find("; not ", what.find("not planar: ")), std::string::npos) << what;
  }
}

}  // namespace
}  // namespace lamina
