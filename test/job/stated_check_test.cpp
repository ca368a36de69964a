// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Programs are judged by the joints that stand in them, also where somebody has edited the file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

/// The value of a word.
double wordOf(const std::string& line, char letter) { return std::stod(line.substr(line.find(letter) + 1)); }

/// A small box whose nozzle leans by 10 deg, and its program.
class StatedCheck : public testing::Test {
 protected:
  StatedCheck() {
    job_.part = folder_.file("box.stl");
    job_.settings.slicing.layer_height_mm = 0.5;
    job_.settings.slicing.first_layer_height_mm = 0.5;
    job_.settings.planning.skirt.count = 0;
    job_.settings.orientation.mode = OrientationMode::Fixed;
    job_.settings.orientation.fixed = {10.0, 30.0};
    writeStl(job_.part, test::boxBetween({0, 0, 0}, {12, 8, 1}));
  }

  void slice(const std::string& machine, const std::string& output) {
    job_.settings.machine.name = machine;
    job_.output = folder_.file(output);
    runSliceJob(job_, nobody_);
    lines_ = linesOf(readFile(job_.output));
  }

  /// Writes the lines as edited, reads them and checks them.
  MachineCheck checked() {
    std::string text;
    for (const std::string& line : lines_) text += line + "\n";
    writeFile(job_.output, text);
    const auto model = kinematicModelOf(job_.settings.machine);
    auto stated = readStatedMotion(job_.output, job_.settings.program, *model);
    if (!stated) throw InvalidProgram("states no joints");
    return checkRun(runAsStated(*model, std::move(*stated), job_.settings.joints), *model,
                    job_.settings.clearance, nobody_);
  }

  /// Of a bead, from the 11th of its motions on: index of a line that states X, Y and filament.
  std::size_t beadLine() const {
    std::size_t beads = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (lines_[i].find("G1 X") == 0 && lines_[i].find(" E") != std::string::npos && ++beads == 11) return i;
    throw InvalidInput("no such line");
  }

  static const Finding* findingOf(const MachineCheck& check, const std::string& what) {
    for (const Finding& finding : check.faults)
      if (finding.what == what) return &finding;
    return nullptr;
  }

  test::ScratchFolder folder_;
  SliceJob job_;
  NoProgress nobody_;
  std::vector<std::string> lines_;
};

TEST_F(StatedCheck, AFiveAxisProgramAsWrittenIsClear) {
  for (const auto coordinates : {FiveAxisCoordinates::ToolTip, FiveAxisCoordinates::Joints}) {
    job_.settings.program.five_axis.coordinates = coordinates;
    slice("five_axis_head_ac", "box.gcode");
    const MachineCheck check = checked();
    EXPECT_TRUE(check.isClear());
    EXPECT_GT(check.waypoints, 50U);
  }
}

TEST_F(StatedCheck, AJointBeyondItsLimitIsFoundByLineAndValue) {
  slice("five_axis_head_ac", "box.gcode");
  const std::size_t at = beadLine();
  lines_[at] += " A377";
  const MachineCheck check = checked();
  const Finding* finding = findingOf(check, "out_of_limits");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->line, at + 1);
  EXPECT_NE(finding->reason.find("joint a at 377.0"), std::string::npos) << finding->reason;
}

TEST_F(StatedCheck, ABranchThatFlipsInsideABeadIsFoundByItsLine) {
  slice("five_axis_head_ac", "box.gcode");
  // The same tool axis by the other branch, from one line of a bead on; A and C stand in the approach alone.
  const std::size_t at = beadLine();
  for (const std::string& line : lines_) {
    if (line.find("G0 A") != 0) continue;
    lines_[at] +=
        " A" + std::to_string(-wordOf(line, 'A')) + " C" + std::to_string(wordOf(line, 'C') - 180.0);
    break;
  }
  const MachineCheck check = checked();
  const Finding* finding = findingOf(check, "jump");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->line, at + 1);
  EXPECT_NE(finding->reason.find("at most 90 deg"), std::string::npos) << finding->reason;
}

TEST_F(StatedCheck, WaitsOfAFiveAxisProgramAreReadBack) {
  slice("five_axis_head_ac", "box.gcode");
  lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(beadLine()), "G4 P451");
  EXPECT_TRUE(checked().isClear());
  lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(beadLine()), "G4");
  EXPECT_THROW(checked(), InvalidProgram);
}

/// The first target of the part: its line, and where its configuration begins.
std::size_t targetLine(const std::vector<std::string>& lines) {
  std::size_t at = 0;
  while (lines.at(at).find("  PROC deposit_1") != 0) ++at;
  return at + 1;
}

TEST_F(StatedCheck, AnArmsProgramHasTheCellOfItsDescriptionAndIsClearAsWritten) {
  job_.settings.program.rapid.configuration = RapidConfiguration::Joints;
  slice("irb_4600", "box.mod");
  const std::string text = readFile(job_.output);
  // The nozzle on the flange tool0 of the URDF: rpy 0, -30, 180 deg is 0.9659 about x and 0.2588 about z.
  EXPECT_NE(text.find("tooldata t_cursoDic:=[TRUE,[[-45,0,387],[0,0.258819045,0,0.965925826]]"),
            std::string::npos)
      << text.substr(0, 600);
  EXPECT_NE(text.find("temple:=[FALSE,TRUE,\"\",[[1350,0,650],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];"),
            std::string::npos);
  EXPECT_NE(text.find("MoveAbsJ [["), std::string::npos);
  EXPECT_LT(text.find("    deposit_start;\n"), text.find("    deposit_1;\n"));
  EXPECT_GT(text.find("    deposit_end;\n"), text.find("    deposit_1;\n"));
  const MachineCheck check = checked();
  EXPECT_TRUE(check.isClear());
  EXPECT_GT(check.waypoints, 50U);
}

TEST_F(StatedCheck, ATurntableIsTheMechanicalUnitOfTheWorkObject) {
  job_.settings.joints.external = ExternalChoice::Follow;
  slice("irb_4600_turntable", "box.mod");
  const std::string text = readFile(job_.output);
  EXPECT_NE(text.find("temple:=[FALSE,FALSE,\"STN1\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];"),
            std::string::npos);
  EXPECT_NE(text.find("    ActUnit STN1;\n"), std::string::npos);
  EXPECT_TRUE(checked().isClear());
}

/// As on a controller whose first axes are taken: the table counts the other way there, from 90 deg.
TEST_F(StatedCheck, AnExternalJointIsTheAxisThatTheSettingsName) {
  job_.settings.joints.external = ExternalChoice::Follow;
  const auto tableValues = [this] {
    const auto model = kinematicModelOf(job_.settings.machine);
    const auto motion = readStatedMotion(job_.output, job_.settings.program, *model);
    std::vector<double> values;
    values.reserve(motion->joints.values.size());
    for (const JointValues& each : motion->joints.values) values.push_back(each[6]);
    return values;
  };
  slice("irb_4600_turntable", "box.mod");
  const std::string plain = readFile(job_.output);
  const std::vector<double> planned = tableValues();
  job_.settings.program.rapid.external_axes = "external_1=-eax_c+90";
  slice("irb_4600_turntable", "box.mod");
  const std::string text = readFile(job_.output);
  EXPECT_NE(text.find("!# external external_1 eax_c -1 90\n"), std::string::npos);
  const std::regex at_first(R"(MoveL \[.*,\[(-?[0-9.]+),9e\+09,9e\+09,9e\+09,9e\+09,9e\+09\]\])");
  const std::regex at_third(R"(MoveL \[.*,\[9e\+09,9e\+09,(-?[0-9.]+),9e\+09,9e\+09,9e\+09\]\])");
  std::sregex_iterator first(plain.begin(), plain.end(), at_first), third(text.begin(), text.end(), at_third);
  ASSERT_GT(std::distance(first, std::sregex_iterator()), 10);
  ASSERT_EQ(std::distance(first, std::sregex_iterator()), std::distance(third, std::sregex_iterator()));
  for (; first != std::sregex_iterator(); ++first, ++third)
    EXPECT_NEAR(std::stod((*third)[1]), 90.0 - std::stod((*first)[1]), 1.1e-3);
  const std::vector<double> read = tableValues();
  ASSERT_EQ(read.size(), planned.size());
  for (std::size_t i = 0; i < read.size(); ++i) EXPECT_NEAR(read[i], planned[i], 2e-5);
  EXPECT_TRUE(checked().isClear());
  const auto note = std::find(lines_.begin(), lines_.end(), "!# external external_1 eax_c -1 90");
  ASSERT_NE(note, lines_.end());
  for (const char* other : {"!# external external_1 eax_b -1 90", "!"}) {
    *note = other;
    EXPECT_THROW(checked(), InvalidProgram) << other;
  }
  *note = "!# external external_1 eax_c 1 90";
  checked();
  EXPECT_NEAR(tableValues().front(), -planned.front(), 2e-5);
}

/// A controller leads the nozzle straight also where the joints at both ends of a move are far apart.
TEST_F(StatedCheck, MovesOfAnArmsProgramAreCheckedOnTheirStraightWay) {
  for (const char* file : {"box.mod", "box.src"}) {
    slice("irb_4600", file);
    const auto model = kinematicModelOf(job_.settings.machine);
    const KinematicModelRun run =
        runAsStated(*model, *readStatedMotion(job_.output, job_.settings.program, *model), {});
    ASSERT_TRUE(run.path.isRunnable()) << file;
    ASSERT_EQ(run.lines.size(), run.path.at.size());
    for (std::size_t i = 1; i < run.path.at.size(); ++i) {
      if (run.path.at[i].path != run.path.at[i - 1].path) continue;
      const Point3 from = model->bedFromNozzle(run.path.values[i - 1]).translation();
      const Point3 to = model->bedFromNozzle(run.path.values[i]).translation();
      const JointValues half = 0.5 * (run.path.values[i - 1] + run.path.values[i]);
      EXPECT_LE((model->bedFromNozzle(half).translation() - 0.5 * (from + to)).norm(), 0.02) << file;
      EXPECT_LE((to - from).norm(), 5.001) << file;
      EXPECT_LE(run.lines[i - 1], run.lines[i]) << file;
    }
  }
}

TEST_F(StatedCheck, AConfigurationThatReachesNothingIsFoundByItsLine) {
  job_.settings.program.rapid.configuration = RapidConfiguration::Joints;
  slice("irb_4600", "box.mod");
  std::string& line = lines_[targetLine(lines_) + 10];
  const std::size_t begin = line.find(",[", line.find("],[") + 2);
  const std::size_t cfx = line.find("],[", begin) - 1;
  line[cfx] = line[cfx] == '7' ? '0' : static_cast<char>(line[cfx] ^ 4);
  const MachineCheck check = checked();
  const Finding* finding = findingOf(check, "configuration");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->line, targetLine(lines_) + 11) << finding->reason << " in " << line;
}

// By poses alone the arm's controller takes the joints nearest to those before, which on a travel over bent
// layers are not those that were planned, and runs into the bed.
TEST_F(StatedCheck, AnArmThatWouldGoAnotherWayByPosesAloneGetsConfigurations) {
  const JobSettings of_nothing;
  job_.settings.orientation = of_nothing.orientation;
  job_.part = "tee";
  job_.settings.slicing.mode = "volumetric";
  job_.settings.input.units.scale = 0.25;
  job_.settings.slicing.layer_height_mm = job_.settings.slicing.first_layer_height_mm = 0.4;
  job_.settings.planning.bead.width_mm = 0.8;
  slice("irb_4600", "tee.mod");
  EXPECT_TRUE(checked().isClear());
}

TEST_F(StatedCheck, PosesOfPlaneLayersAreSaidToBeUncheckedWhoeverChoseTheMode) {
  job_.settings.machine.name = "five_axis_table_ac";
  job_.output = folder_.file("poses.csv");
  for (const char* mode : {"planar", "auto"}) {
    job_.settings.slicing.mode = mode;
    const std::vector<std::string> notes = runSliceJob(job_, nobody_).summary.notes;
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return note.find("it was not checked whether the machine runs into") == 0;
    })) << mode;
  }
}

TEST_F(StatedCheck, AnotherToolThanThatOfTheDescriptionIsRefused) {
  job_.settings.program.rapid.tool_frame = {0, 0, 0, 1, 0, 0, 0};
  slice("irb_4600", "box.mod");
  try {
    checked();
    FAIL() << "expected it to be refused";
  } catch (const InvalidProgram& error) {
    EXPECT_NE(std::string(error.what()).find("tool"), std::string::npos) << error.what();
  }
}

TEST_F(StatedCheck, BeadsNearASingularityAreCounted) {
  job_.settings.orientation.mode = OrientationMode::LayerNormal;
  job_.settings.program.five_axis.use = FiveAxisUse::Always;
  slice("five_axis_head_ac", "level.gcode");
  const auto model = kinematicModelOf(job_.settings.machine);
  auto stated = readStatedMotion(job_.output, job_.settings.program, *model);
  ASSERT_TRUE(stated);
  const SingularBeads beads =
      singularBeads(runAsStated(*model, std::move(*stated), job_.settings.joints), *model, 6.0);
  EXPECT_GT(beads.near, 10U);
  EXPECT_DOUBLE_EQ(beads.share(), 1.0) << "a level nozzle is along the axis of c everywhere";
  EXPECT_LT(beads.least_deg, 1e-6);
  EXPECT_GT(beads.line, 0U);
}

TEST_F(StatedCheck, SliceSaysTheTimeThatTheCheckSays) {
  slice("five_axis_head_ac", "box.gcode");
  NoProgress nobody;
  const SliceSummary summary = runSliceJob(job_, nobody).summary;
  const auto model = kinematicModelOf(job_.settings.machine);
  const RunSettings settings = runSettings(job_.settings);
  const TimedRun timed =
      inTime(runAsStated(*model, std::move(*readStatedMotion(job_.output, job_.settings.program, *model)),
                         settings.joints),
             *model, settings.timing);
  EXPECT_NEAR(summary.estimated_time_s, timed.figures.total_s, 0.01 * timed.figures.total_s);
  EXPECT_NEAR(summary.slow_bead_share, timed.figures.slow_bead_share, 0.02);
  EXPECT_GT(summary.slow_bead_share, 0.0);
}

TEST_F(StatedCheck, LinearAxesStateNoJoints) {
  job_.settings.orientation.mode = OrientationMode::LayerNormal;
  slice("cartesian_gantry", "flat.gcode");
  const auto model = kinematicModelOf(job_.settings.machine);
  EXPECT_FALSE(readStatedMotion(job_.output, job_.settings.program, *model));
}

TEST_F(StatedCheck, ProgramsOfOtherRobotsAsWrittenAreClearAndHoldTheToolpath) {
  job_.settings.program.robot.may_cut = true;
  for (const char* file : {"box.src", "box.script", "BOX.ls", "BOX.jbi"}) {
    slice("irb_4600", file);
    const MachineCheck check = checked();
    EXPECT_TRUE(check.isClear()) << file;
    EXPECT_GT(check.waypoints, 50U) << file;
  }
}

TEST_F(StatedCheck, ExternalAxesOfOtherRobotsAreReadBack) {
  for (const char* file : {"box.src", "BOX.ls"}) {
    slice("irb_4600_turntable", file);
    EXPECT_TRUE(checked().isClear()) << file;
  }
  for (const char* file : {"box.script", "BOX.jbi"})
    EXPECT_THROW(slice("irb_4600_turntable", file), InvalidInput);
}

TEST_F(StatedCheck, APoseThatAnotherRobotCannotReachIsFoundByItsLine) {
  slice("irb_4600", "box.src");
  std::size_t at = 0;
  while (lines_[at].find("C_DIS") == std::string::npos || lines_[at].find("LIN") != 0) ++at;
  const std::size_t z = lines_[at].find("Z ");
  lines_[at].replace(z, lines_[at].find(',', z) - z, "Z 9000.000");
  const MachineCheck check = checked();
  const Finding* finding = findingOf(check, "out_of_reach");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->line, at + 1);
}

TEST_F(StatedCheck, AProgramForAnotherToolOrWithoutAStartIsRefused) {
  slice("irb_4600", "box.src");
  const std::vector<std::string> written = lines_;
  const auto refusal = [&](const std::string& begin, const std::string& to) -> std::string {
    lines_ = written;
    for (std::string& line : lines_)
      if (line.find(begin) == 0) line = to;
    try {
      checked();
    } catch (const InvalidProgram& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal(";# tool", ";# tool 0 0 999 1 0 0 0").find("have the tool at (0.000, 0.000, 999.000) mm"),
            std::string::npos);
  EXPECT_NE(refusal(";# bed", ";# carried_bed 0 0 0 1 0 0 0").find("a bed that an external axis carries"),
            std::string::npos);
  EXPECT_NE(
      refusal(";# tool", "").find("has no note of its tool; expected one, of (-45.000, 0.000, 387.000) mm"),
      std::string::npos);
  EXPECT_NE(
      refusal(";# bed", "").find("has no note of its bed; expected one, of (1350.000, 0.000, 650.000) mm"),
      std::string::npos);
  EXPECT_NE(refusal("PTP", "").find("no move of the joints comes to the part"), std::string::npos);
}

}  // namespace
}  // namespace lamina
