// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The load of the tool in a module, and axes that an arm does not have.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

class RapidLoad : public testing::Test {
 protected:
  RapidLoad() {
    job_.part = folder_.file("box.stl");
    job_.output = folder_.file("box.mod");
    job_.settings.slicing.layer_height_mm = 0.5;
    job_.settings.slicing.first_layer_height_mm = 0.5;
    job_.settings.planning.skirt.count = 0;
    job_.settings.machine.name = "irb_4600";
    writeStl(job_.part, test::boxBetween({0, 0, 0}, {12, 8, 1}));
  }

  std::string sliced() {
    notes_ = runSliceJob(job_, nobody_).summary.notes;
    return readFile(job_.output);
  }

  bool isNoted(const std::string& text) const {
    return std::any_of(notes_.begin(), notes_.end(),
                       [&](const std::string& note) { return note.find(text) != std::string::npos; });
  }

  test::ScratchFolder folder_;
  SliceJob job_;
  NoProgress nobody_;
  std::vector<std::string> notes_;
};

TEST_F(RapidLoad, ThatNobodyGaveIsSaid) {
  const std::string text = sliced();
  EXPECT_NE(text.find("! load of the tool: 1 kg, centre at [0,0,1] mm over the flange, given by nobody: "
                      "rapid.tool_mass_kg\n"),
            std::string::npos);
  EXPECT_TRUE(isNoted("a tool of 1 kg with its centre at [0,0,1] mm over the flange, which nobody gave"));
}

TEST_F(RapidLoad, OfTheOtherLanguagesIsThatOfTheModule) {
  job_.settings.program.robot.tool_mass_kg = 30.0;
  job_.settings.program.robot.tool_centre_of_gravity_mm = {0, 20, 150};
  const std::string text = sliced();
  EXPECT_NE(text.find(",[30,[0,20,150],[1,0,0,0],0,0,0]];\n"), std::string::npos);
  EXPECT_NE(text.find("! load of the tool: 30 kg, centre at [0,20,150] mm over the flange\n"),
            std::string::npos);
  EXPECT_FALSE(isNoted("nobody gave"));
  EXPECT_FALSE(isNoted("robot_program"));
  job_.settings.program.rapid.tool_mass_kg = 12.0;
  EXPECT_NE(sliced().find(",[12,[0,0,1],[1,0,0,0],0,0,0]];\n"), std::string::npos);
}

/// extjoint of RAPID: 9E9 for an axis that is not connected.
TEST_F(RapidLoad, AxesThatTheArmDoesNotHaveAreNotInUse) {
  std::string text = sliced();
  EXPECT_EQ(text.find("[0.000,9e+09"), std::string::npos);
  EXPECT_NE(text.find("[9e+09,9e+09,9e+09,9e+09,9e+09,9e+09]"), std::string::npos);
  job_.settings.program.rapid.external_axis = 5.0;
  EXPECT_NE(sliced().find("[5.000,9e+09,9e+09,9e+09,9e+09,9e+09]"), std::string::npos);
  job_.settings.program.rapid.external_axis = 0.0;
  job_.settings.machine.name = "irb_4600_turntable";
  text = sliced();
  EXPECT_EQ(text.find("[9e+09"), std::string::npos);
}

}  // namespace
}  // namespace lamina
