// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Programs that report joints, from part to file and read back.
#include "job/joint_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "support/arms.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

double toolAxisAngle(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Point3 tool_axis = a * Point3::UnitZ();
  const Point3 other = b * Point3::UnitZ();
  return std::atan2(tool_axis.cross(other).norm(), tool_axis.dot(other));
}

/// A small box whose nozzle leans by 10 deg.
class JointProgramTest : public testing::Test {
 protected:
  JointProgramTest() {
    job_.part = folder_.file("box.stl");
    job_.settings.slicing.layer_height_mm = 0.5;
    job_.settings.slicing.first_layer_height_mm = 0.5;
    job_.settings.planning.skirt.count = 0;
    writeStl(job_.part, test::boxBetween({0, 0, 0}, {12, 8, 1}));
  }

  void lean() {
    job_.settings.orientation.mode = OrientationMode::Fixed;
    job_.settings.orientation.fixed = {10.0, 30.0};
  }

  SlicedPart slice(const std::string& machine, const std::string& output) {
    job_.settings.machine.name = machine;
    job_.output = folder_.file(output);
    return runSliceJob(job_, nobody_);
  }

  Toolpath readBack() const { return readProgram(job_.output, job_.settings.program, job_.settings.machine); }

  /// The file reports the very places that were led to, and the waypoints asked for are among them.
  void expectSame(const Toolpath& read, const SlicedPart& sliced, double within_mm) {
    SlicedPart led = sliced;
    const auto joint_program = planJointProgram(job_, buildSpaceOf(job_.settings.machine), led, nobody_);
    ASSERT_TRUE(joint_program);
    ASSERT_EQ(read.layers.size(), sliced.toolpath.layers.size());
    for (std::size_t l = 0; l < read.layers.size(); ++l) {
      const auto& paths = joint_program->toolpath.layers[l].paths;
      ASSERT_EQ(read.layers[l].paths.size(), paths.size());
      for (std::size_t p = 0; p < paths.size(); ++p) {
        expectSame(read.layers[l].paths[p], paths[p], within_mm);
        for (const Eigen::Quaterniond& turn : read.layers[l].paths[p].orientation.values())
          EXPECT_LT(toolAxisAngle(turn, sliced.toolpath.layers[l].paths[p].orientation.at(0)), 1e-6);
      }
    }
    EXPECT_NEAR(totals(read).deposition_mm, totals(sliced.toolpath).deposition_mm, 0.01);
  }

  void expectSame(const Path& read, const Path& joint_program, double within_mm) const {
    ASSERT_EQ(read.points.size(), joint_program.points.size());
    EXPECT_EQ(read.role, joint_program.role);
    for (std::size_t i = 0; i < joint_program.points.size(); ++i) {
      EXPECT_LT((read.points[i] - bed_from_part_ * joint_program.points[i]).norm(), within_mm);
      EXPECT_LT(toolAxisAngle(read.orientation.at(i), joint_program.orientation.at(i)), 1e-6);
    }
  }

  std::string refusal(const std::string& machine, const std::string& output) {
    try {
      slice(machine, output);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  bool hasWritten() const { return folder_.fileCount() > 1; }

  test::ScratchFolder folder_;
  SliceJob job_;
  NoProgress nobody_;
  Eigen::Isometry3d bed_from_part_ = Eigen::Isometry3d::Identity();
};

TEST_F(JointProgramTest, FiveAxisGcodeOfATiltedToolpathReportsItsPoses) {
  lean();
  for (const char* machine : {"five_axis_head_table", "five_axis_head_ac", "five_axis_table_ac"})
    for (const auto coordinates : {FiveAxisCoordinates::ToolTip, FiveAxisCoordinates::Joints}) {
      job_.settings.program.five_axis.coordinates = coordinates;
      const SlicedPart sliced = slice(machine, "box.gcode");
      bed_from_part_ = sliced.bed_from_part;
      // 4 decimals of three lengths; of joints also 5 of an angle at some 300 mm.
      expectSame(readBack(), sliced, coordinates == FiveAxisCoordinates::ToolTip ? 1e-4 : 4e-4);
    }
}

TEST_F(JointProgramTest, WhatALanguageCannotStateIsRefusedBeforeThePartIsRead) {
  job_.part = folder_.file("missing.stl");
  const auto refusal = [&](const std::string& machine, const std::string& output) -> std::string {
    try {
      slice(machine, output);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal("irb_4600", "1box.src").find("the program's name is '1box'"), std::string::npos);
  EXPECT_NE(refusal("irb_4600_turntable", "box.script").find("the arm has 1 external axes"),
            std::string::npos);
  EXPECT_NE(
      refusal("irb_4600_turntable", "box.jbi").find("external axes, and inform.external_pulses 0 numbers"),
      std::string::npos);
  EXPECT_NE(refusal("irb_4600_turntable", "box.src").find("missing.stl"), std::string::npos);
  job_.settings.program.robot.arc.process = RobotProcess::Schedules;
  EXPECT_NE(refusal("irb_4600", "box.script").find("URScript has no statement"), std::string::npos);
}

/// An arm that stands the other way round has the part where joint_1 has its limits, at half a turn to either
/// side, and turns it by a degree only: the way there costs little and winds up.
TEST_F(JointProgramTest, APartAcrossTheLimitsOfAFoldedArmIsLedTheOtherWayRound) {
  writeStl(job_.part, test::boxBetween({0, 0, 0}, {6, 6, 6}));
  job_.settings.slicing.layer_height_mm = 1.0;
  job_.settings.planning.bead.width_mm = 2.0;
  job_.settings.planning.skirt = {};
  for (const auto yaw : {YawChoice::Free, YawChoice::Held}) {
    job_.settings.joints.yaw = yaw;
    EXPECT_NO_THROW(slice("irb_4600", "cube.mod"));
    EXPECT_TRUE(std::filesystem::exists(job_.output));
  }
}

TEST_F(JointProgramTest, ALevelToolpathKeepsThePlainProgramUnlessAsked) {
  slice("five_axis_head_table", "level.gcode");
  EXPECT_EQ(readFile(job_.output).find(";FIVE_AXIS:"), std::string::npos);
  job_.settings.program.five_axis.use = FiveAxisUse::Always;
  const SlicedPart sliced = slice("five_axis_head_table", "asked.gcode");
  EXPECT_NE(readFile(job_.output).find(";FIVE_AXIS:"), std::string::npos);
  bed_from_part_ = sliced.bed_from_part;
  expectSame(readBack(), sliced, 1e-4);
}

TEST_F(JointProgramTest, WhatAMachineCannotRunLeavesNoFile) {
  lean();
  EXPECT_NE(refusal("cartesian_gantry", "box.gcode").find("deg"), std::string::npos);
  EXPECT_NE(refusal("irb_4600", "box.gcode").find("is a robot"), std::string::npos);
  job_.settings.orientation.fixed.lean_deg = 75.0;
  job_.settings.orientation.limits.max_off_normal_deg = 90.0;
  const std::string text = refusal("five_axis_head_ab", "box.gcode");  // its joints turn by 60 deg at most
  EXPECT_EQ(text.rfind("layer 0, path 0, waypoint 0: ", 0), 0U) << text;
  EXPECT_NE(text.find("the first of "), std::string::npos) << text;
  EXPECT_FALSE(hasWritten());
}

/// At 50 deg the head's block, 30 mm to each side from 25 mm over the tip, is in the bed.
TEST_F(JointProgramTest, AProgramInWhichTheMachineCollidesIsRefusedUnlessAsked) {
  job_.settings.orientation.mode = OrientationMode::Fixed;
  job_.settings.orientation.fixed = {50.0, 0.0};
  EXPECT_THROW(slice("five_axis_head_table", "box.gcode"), Unreachable);
  EXPECT_FALSE(std::filesystem::exists(job_.output));
  EXPECT_NO_THROW(slice("five_axis_head_table", "box.csv")) << "poses are for any head";
  job_.settings.clearance.need = ClearanceNeed::Always;
  EXPECT_THROW(slice("five_axis_head_table", "other.csv"), Unreachable);
  job_.settings.clearance.need = ClearanceNeed::Never;
  EXPECT_NO_THROW(slice("five_axis_head_table", "box.gcode"));
  EXPECT_TRUE(std::filesystem::exists(job_.output));
}

// Its table of poses states no joints; the program does, and its time is that of the joints.
TEST_F(JointProgramTest, ATimeOfTheTipAloneIsNotedWithHowToLearnThatOfTheJoints) {
  const auto noteOf = [&](const std::string& machine, const std::string& output) {
    for (const std::string& note : slice(machine, output).summary.notes)
      if (note.find("print time") != std::string::npos) return note;
    return std::string();
  };
  EXPECT_EQ(noteOf("irb_4600", "box.csv"),
            "the print time is that of the nozzle's tip alone; the joints may need longer: 'lamina check " +
                folder_.file("box.csv") + " --machine irb_4600' tells the time within their limits");
  EXPECT_EQ(noteOf("irb_4600", "box.src"), "");
  EXPECT_EQ(noteOf("cartesian_gantry", "box.csv"), "");
  EXPECT_EQ(noteOf("five_axis_head_table", "box.csv"), "") << "nothing turns, and no joint is slower";
  lean();
  EXPECT_NE(noteOf("five_axis_head_table", "leaning.csv"), "");
  EXPECT_EQ(noteOf("five_axis_head_table", "leaning.gcode"), "");
}

TEST_F(JointProgramTest, WhatIsNotCheckedAgainstTheMachineIsNotedWithHowToCheckIt) {
  const auto notes = [&](const std::string& output) {
    std::string all;
    for (const std::string& note : slice("five_axis_head_table", output).summary.notes) all += note + '\n';
    return all;
  };
  EXPECT_EQ(notes("level.csv").find("not checked"), std::string::npos) << "nothing turns";
  lean();
  const std::string unchecked = notes("leaning.csv");
  EXPECT_NE(unchecked.find("not checked"), std::string::npos) << unchecked;
  EXPECT_NE(
      unchecked.find("'lamina check " + folder_.file("leaning.csv") + " --machine five_axis_head_table'"),
      std::string::npos)
      << unchecked;
  EXPECT_EQ(notes("leaning.gcode").find("not checked"), std::string::npos) << "a program is checked";
  job_.settings.clearance.need = ClearanceNeed::Always;
  EXPECT_EQ(notes("clear.csv").find("not checked"), std::string::npos);
  job_.settings.clearance.need = ClearanceNeed::Never;
  EXPECT_EQ(notes("unasked.csv").find("not checked"), std::string::npos) << "nobody wants to know";
}

TEST_F(JointProgramTest, ARefusalSaysWhatMeetsWhatAndWhatToTry) {
  job_.settings.orientation.mode = OrientationMode::Fixed;
  job_.settings.orientation.fixed = {50.0, 0.0};
  const std::string text = refusal("five_axis_head_table", "box.gcode");
  EXPECT_NE(text.find("' in the bed at "), std::string::npos) << text;
  EXPECT_NE(text.find(" from layer 0 on"), std::string::npos) << text;
  EXPECT_NE(text.find("; try another machine (machine.name), a tool axis that leans less"), std::string::npos)
      << text;
}

TEST_F(JointProgramTest, TheToolAxisIsRaisedWhereTheHeadWouldBeInTheBed) {
  job_.settings.orientation.mode = OrientationMode::Fixed;
  job_.settings.orientation.fixed = {50.0, 0.0};
  job_.settings.clearance.raises_tool_axis = true;
  const SlicedPart sliced = slice("five_axis_head_table", "box.gcode");
  double least = 180.0;
  double most = 0.0;
  for (const ToolpathLayer& layer : sliced.toolpath.layers)
    for (const Path& path : layer.paths)
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        const double lean_deg =
            toolAxisAngle(path.orientation.at(i), Eigen::Quaterniond(0, 1, 0, 0)) * 180.0 / M_PI;
        least = std::min(least, lean_deg);
        most = std::max(most, lean_deg);
      }
  // With the tip half a millimetre over the bed atan(25.5 / 42.4) is 31.0 deg, for the edges of that block.
  EXPECT_LT(most, 50.0);
  EXPECT_GT(least, 30.0);
  EXPECT_LT(least, 31.1);
  ASSERT_FALSE(sliced.summary.notes.empty());
  EXPECT_NE(sliced.summary.notes.back().find("the tool axis leans less"), std::string::npos);
}

// Targets of RAPID that state no joints are led to with the tool held about its axis as the toolpath has it.
TEST_F(JointProgramTest, APlanIsCheckedWithTheYawThatItsProgramIsRunWith) {
  job_.settings.machine.name = "irb_4600";
  const std::unique_ptr<KinematicModel> arm = kinematicModelOf(job_.settings.machine);
  const auto yawFor = [&](const std::string& output) {
    job_.output = output;
    return jointsOf(job_, *arm).yaw;
  };
  job_.settings.joints.yaw = YawChoice::Free;
  job_.settings.program.rapid.configuration = RapidConfiguration::Joints;
  EXPECT_EQ(yawFor("part.mod"), YawChoice::Free);
  job_.settings.program.rapid.configuration = RapidSettings().configuration;
  ASSERT_NE(job_.settings.program.rapid.configuration, RapidConfiguration::Joints);
  EXPECT_EQ(yawFor("part.mod"), YawChoice::Held);
  EXPECT_EQ(yawFor("part.src"), YawChoice::Free);
  EXPECT_EQ(yawFor("part.csv"), YawChoice::Free);
}

TEST_F(JointProgramTest, AnotherMachineDoesNotReadTheProgram) {
  lean();
  slice("five_axis_head_ac", "box.gcode");
  for (const char* machine : {"five_axis_table_bc", "cartesian_gantry", "irb_4600"}) {
    job_.settings.machine.name = machine;
    EXPECT_THROW(readBack(), InvalidProgram) << machine;
  }
}

/// A target of a module: where the nozzle is over the bed, by which joints, and the first external axis.
struct Target {
  Eigen::Isometry3d bed_from_nozzle = Eigen::Isometry3d::Identity();
  AbbConfiguration configuration;
  double external = 0.0;  ///< as it stands there [mm, deg]
};

std::vector<Target> targetsOf(const std::string& text) {
  std::vector<Target> targets;
  // After the approach and the retract.
  for (std::size_t at = text.find("MoveL [[", text.find("  PROC deposit_1")); at != std::string::npos;
       at = text.find("MoveL [[", at + 1)) {
    Target target;
    Point3 tip;
    Eigen::Quaterniond turn;
    AbbConfiguration& read = target.configuration;
    const int count =
        std::sscanf(text.c_str() + at, "MoveL [[%lf,%lf,%lf],[%lf,%lf,%lf,%lf],[%d,%d,%d,%d],[%lf", &tip.x(),
                    &tip.y(), &tip.z(), &turn.w(), &turn.x(), &turn.y(), &turn.z(), &read.cf1, &read.cf4,
                    &read.cf6, &read.cfx, &target.external);
    EXPECT_EQ(count, 12);
    target.bed_from_nozzle = Eigen::Translation3d(tip) * turn.normalized();
    targets.push_back(target);
  }
  return targets;
}

/// Whether a target and its configuration give an arm these joints, but for whole turns.
bool leadsTo(const JointValues& joints, const Target& target, const KinematicModel& arm) {
  for (const InverseSolution& solution : arm.solutions(target.bed_from_nozzle, joints)) {
    if (abbConfiguration(arm, solution.values).cfx != target.configuration.cfx) continue;
    for (Eigen::Index j = 0; j < joints.size(); ++j)
      if (std::abs(std::remainder(solution.values[j] - joints[j], 2.0 * M_PI)) > 1e-5) return false;
    const AbbConfiguration expected = abbConfiguration(arm, joints);
    return expected.cf1 == target.configuration.cf1 && expected.cf4 == target.configuration.cf4 &&
           expected.cf6 == target.configuration.cf6;
  }
  return false;
}

TEST_F(JointProgramTest, RapidTargetsLeadAnArmThroughTheJointsThatWereChecked) {
  lean();
  job_.settings.program.rapid.configuration = RapidConfiguration::Joints;
  for (const char* machine : {"irb_4600", "irb_4600_turntable"}) {
    SlicedPart sliced = slice(machine, "box.mod");
    bed_from_part_ = sliced.bed_from_part;
    expectSame(readBack(), sliced, 1e-4);
    const auto joint_program = planJointProgram(job_, buildSpaceOf(job_.settings.machine), sliced, nobody_);
    std::size_t station = 0;  // a path that begins where the one before ended begins without a target
    for (const Target& target : targetsOf(readFile(job_.output))) {
      while (station < joint_program->joints.values.size() &&
             !leadsTo(joint_program->joints.values[station], target, *joint_program->model))
        ++station;
      ASSERT_LT(station, joint_program->joints.values.size()) << machine;
    }
    EXPECT_EQ(station + 1, joint_program->joints.values.size());
  }
}

TEST_F(JointProgramTest, RoundedSpeedsAndSplitFilesAreReported) {
  job_.settings.planning.feed.outer_wall_mm_s = 6.7;
  job_.settings.program.robot.may_cut = true;
  job_.settings.program.robot.fanuc.max_lines = 150;
  const SlicedPart sliced = slice("irb_4600", "box.ls");
  const auto reported = [&](const std::string& part) {
    return std::any_of(sliced.summary.notes.begin(), sliced.summary.notes.end(),
                       [&](const std::string& note) { return note.find(part) != std::string::npos; });
  };
  EXPECT_TRUE(reported("0.50 %: 6.7 mm/s is written as 6.667 mm/s"));
  EXPECT_TRUE(reported("files, 'BOX_1.ls' to 'BOX_"));
}

// Such a program would run with the process on and no wire.
TEST_F(JointProgramTest, OutputsOfValuesThatNoPathStatesAreReported) {
  job_.settings.runs.levels.values = "laser_power_w=1000";
  job_.settings.program.robot.levels = "laser_power_w=1*0.0005, wire_speed_mm_s=2*0.04";
  const std::vector<std::string> notes = slice("irb_4600", "box.src").summary.notes;
  const auto naming = [&](const std::string& value) {
    return std::count_if(notes.begin(), notes.end(), [&](const std::string& note) {
      return note.find("robot_program.levels leads '" + value + "'") == 0;
    });
  };
  EXPECT_EQ(naming("laser_power_w"), 0);
  ASSERT_EQ(naming("wire_speed_mm_s"), 1);
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("to output 2, which stays at 0: no path states that value") != std::string::npos;
  }));
}

/// Heights of the poses of a script [m].
std::vector<double> heightsIn(const std::string& script) {
  std::vector<double> heights;
  const std::regex pose("move[lp]\\(p\\[[^,]+,[^,]+,([^,]+),");
  for (std::sregex_iterator found(script.begin(), script.end(), pose), end; found != end; ++found)
    heights.push_back(std::stod((*found)[1]));
  return heights;
}

// Each is started by hand: the arm waits between two of them, and may have been moved.
TEST_F(JointProgramTest, ScriptsOfASplitProgramBeginAndEndOffThePart) {
  lean();
  job_.settings.program.robot.may_cut = true;
  job_.settings.program.robot.urscript.max_points = 30;
  const SlicedPart sliced = slice("irb_4600", "box.script");
  bed_from_part_ = sliced.bed_from_part;
  ASSERT_GT(folder_.fileCount(), 5U);
  const double back_m = 1e-3 * job_.settings.program.robot.approach_mm;
  for (const char* name : {"box_2.script", "box_3.script"}) {
    const std::string script = readFile(folder_.file(name));
    const std::vector<double> heights = heightsIn(script);
    ASSERT_GT(heights.size(), 3U);
    EXPECT_LT(script.find("movej("), script.find("movel("));
    EXPECT_NEAR(heights.back() - heights[heights.size() - 2], back_m * std::cos(10.0 * M_PI / 180.0), 1e-5);
  }
  EXPECT_NEAR(totals(readBack()).deposition_mm, totals(sliced.toolpath).deposition_mm, 0.05);
}

TEST_F(JointProgramTest, FanucsListingsMoveByCoordOverABedThatTurns) {
  lean();
  job_.settings.joints.external = ExternalChoice::Follow;
  job_.settings.program.robot.fanuc.positioner_frame = 4;
  const SlicedPart sliced = slice("irb_4600_turntable", "box.ls");
  bed_from_part_ = sliced.bed_from_part;
  const std::string listing = readFile(job_.output);
  const std::regex linear(":L P\\[\\d+\\] .*"), coordinated(":L P\\[\\d+\\] .* (FINE|CNT100) COORD .*");
  const auto count = [&listing](const std::regex& line) {
    return std::distance(std::sregex_iterator(listing.begin(), listing.end(), line), std::sregex_iterator());
  };
  EXPECT_GT(count(linear), 10);
  EXPECT_EQ(count(linear), count(coordinated));
  EXPECT_NE(listing.find("GP2:\n\tUF : 4, UT : 1,"), std::string::npos);
  EXPECT_NEAR(totals(readBack()).deposition_mm, totals(sliced.toolpath).deposition_mm, 0.05);
  job_.settings.program.robot.fanuc.is_coordinated = false;
  const std::string refused = refusal("irb_4600_turntable", "alone.ls");
  EXPECT_NE(refused.find("fanuc.coordinated is false, and axis external_1 turns the bed to"),
            std::string::npos)
      << refused;
  EXPECT_FALSE(std::filesystem::exists(job_.output));
  job_.settings.joints.external = ExternalChoice::Held;
  slice("irb_4600_turntable", "alone.ls");
  EXPECT_EQ(readFile(job_.output).find("COORD"), std::string::npos);
}

TEST_F(JointProgramTest, ATurntableThatFollowsIsReportedAtEachTarget) {
  lean();
  job_.settings.joints.external = ExternalChoice::Follow;
  SlicedPart sliced = slice("irb_4600_turntable", "box.mod");
  const auto joint_program = planJointProgram(job_, buildSpaceOf(job_.settings.machine), sliced, nobody_);
  ASSERT_TRUE(joint_program);
  const std::vector<Target> targets = targetsOf(readFile(job_.output));
  EXPECT_NEAR(targets.front().external, joint_program->joints.values.front()[6] * 180.0 / M_PI, 6e-4);
  EXPECT_NEAR(targets.back().external, joint_program->joints.values.back()[6] * 180.0 / M_PI, 6e-4);
  job_.settings.program.rapid.variant = RapidVariant::Powder3Axes;
  for (const ExternalChoice choice : {ExternalChoice::Follow, ExternalChoice::Gravity}) {
    job_.settings.joints.external = choice;
    EXPECT_NE(refusal("irb_4600_turntable", "offsets.mod").find("joints.external is not held"),
              std::string::npos);
  }
  job_.settings.joints.rail = RailChoice::Steps;
  EXPECT_NE(refusal("irb_4600_turntable", "offsets.mod").find("joints.rail is not held"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(job_.output));
}

TEST_F(JointProgramTest, AnArmThatReportsNoJointsGetsTheTargetsOfTheToolpath) {
  const SlicedPart sliced = slice("irb_4600", "box.mod");
  const Toolpath read = readBack();
  ASSERT_EQ(totals(read).waypoints, totals(sliced.toolpath).waypoints);
  const Path& path = sliced.toolpath.layers[0].paths[0];
  EXPECT_LT(read.layers[0].paths[0].orientation.at(0).angularDistance(path.orientation.at(0)), 1e-6);
}

TEST_F(JointProgramTest, ProgramsForAnArmOfSevenAxesAreRefusedAndItsToolpathIsNot) {
  const std::string urdf = folder_.file("seven.urdf");
  writeFile(urdf, test::sphericalSevenOverPlate());
  job_.settings.machine.urdf = urdf;
  for (const char* output : {"box.mod", "box.src", "box.script", "box.ls", "box.jbi", "box.gcode"}) {
    job_.output = folder_.file(output);
    try {
      runSliceJob(job_, nobody_);
      ADD_FAILURE() << output << " is not refused";
    } catch (const InvalidInput& refused) {
      EXPECT_NE(std::string(refused.what()).find("an arm of seven axes"), std::string::npos)
          << refused.what();
    }
    EXPECT_FALSE(std::filesystem::exists(job_.output));
  }
  job_.output = folder_.file("box.csv");
  EXPECT_FALSE(runSliceJob(job_, nobody_).toolpath.layers.empty());
}

}  // namespace
}  // namespace lamina
