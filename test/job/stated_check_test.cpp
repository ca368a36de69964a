// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Programs are judged by the joints that stand in them, also where somebody has edited the file.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
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

TEST_F(StatedCheck, LinearAxesStateNoJoints) {
  job_.settings.orientation.mode = OrientationMode::LayerNormal;
  slice("cartesian_gantry", "flat.gcode");
  const auto model = kinematicModelOf(job_.settings.machine);
  EXPECT_FALSE(readStatedMotion(job_.output, job_.settings.program, *model));
}

}  // namespace
}  // namespace lamina
