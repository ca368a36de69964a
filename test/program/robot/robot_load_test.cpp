// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What the flange carries, as the controller is told.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "lamina/program/robot/robot_motion.hpp"
#include "lamina/program/robot/robot_reader.hpp"
#include "support/robot_programs.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

RobotProgramSettings withLoad() {
  RobotProgramSettings settings;
  settings.tool_mass_kg = 12.5;
  settings.tool_centre_of_gravity_mm = {-10, 0, 80.5};
  return settings;
}

std::string loadedText(RobotLanguage language, const RobotProgramSettings& settings) {
  return test::robotFiles(language, test::twoLayers(), settings)[0].text;
}

TEST(RobotLoad, OfTheToolGoesWithItInKrl) {
  RobotProgramSettings settings;
  settings.tool_number = 4;
  EXPECT_NE(loadedText(RobotLanguage::Krl, settings).find("$TOOL=TOOL_DATA[4]\n$LOAD=LOAD_DATA[4]\n"),
            std::string::npos);
}

TEST(RobotLoad, IsWrittenWhereItIsKnown) {
  EXPECT_NE(loadedText(RobotLanguage::Krl, withLoad())
                .find("\n$LOAD={M 12.5,CM {X -10.000,Y 0.000,Z 80.500,A 0.0,B 0.0,C 0.0},J {X 0.0,Y 0.0,Z "
                      "0.0}}\n"),
            std::string::npos);
  EXPECT_NE(loadedText(RobotLanguage::UrScript, withLoad())
                .find("\n  set_payload(12.5, [-0.010000, 0.000000, 0.080500])\n"),
            std::string::npos);
  EXPECT_NE(loadedText(RobotLanguage::Fanuc, withLoad()).find("!# load 12.5 -10 0 80.5"), std::string::npos);
  EXPECT_NE(loadedText(RobotLanguage::Inform, withLoad()).find("'# load 12.5 -10 0 80.5"), std::string::npos);
  EXPECT_EQ(loadedText(RobotLanguage::UrScript, {}).find("set_payload"), std::string::npos);
}

TEST(RobotLoad, OfTheControllerIsChosenInFanucListings) {
  EXPECT_EQ(loadedText(RobotLanguage::Fanuc, {}).find("PAYLOAD"), std::string::npos);
  RobotProgramSettings settings;
  settings.fanuc.payload = 3;
  const auto files = test::robotFiles(RobotLanguage::Fanuc, test::twoLayers(), settings);
  const std::size_t at = files[0].text.find(":  PAYLOAD[3] ;\n");
  ASSERT_NE(at, std::string::npos) << files[0].text;
  EXPECT_GT(at, files[0].text.find("UTOOL_NUM="));
  EXPECT_LT(at, files[0].text.find(" P[1] "));
  EXPECT_EQ(totals(readRobotProgram(files, "part")).deposition_runs, 2U);
}

TEST(RobotLoad, IsReadBackAndSaidOfTheCell) {
  for (const RobotLanguage language : kRobotLanguages) {
    const auto files = test::robotFiles(language, test::twoLayers(), withLoad());
    const EquippedToolpath read = readEquippedRobotProgram(files, "part");
    EXPECT_EQ(read.equipment.process.count("a tool of 12.5 kg with its centre at -10 0 80.5 mm"), 1U)
        << toString(language);
    EXPECT_EQ(totals(read.toolpath).deposition_runs, 2U);
  }
}

TEST(RobotLoad, NeedsMassAndCentre) {
  RobotProgramSettings settings = withLoad();
  settings.tool_centre_of_gravity_mm.clear();
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
  settings = withLoad();
  settings.tool_mass_kg = 0.0;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
}

/// A script of the arm as it is written for it, with one statement edited.
class RobotTool : public testing::Test {
 protected:
  RobotTool() : arm_(kinematicModelByName("irb_4600")) {
    NoProgress nobody;
    const Toolpath toolpath = test::twoLayers();
    const JointPath joints = planJointPath(toolpath, Eigen::Isometry3d::Identity(), *arm_, {}, nobody);
    const RobotMotion robot{*arm_, joints};
    files_ = robotProgram(toolpath, Eigen::Isometry3d::Identity(),
                          {RobotLanguage::UrScript, "script", withLoad()}, &robot);
  }

  std::string refusal(const std::string& from, const std::string& to) {
    std::string& text = files_[0].text;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) return "no " + from;
    text.replace(at, from.size(), to);
    try {
      readRobotMotion(files_, "part", *arm_);
    } catch (const InvalidProgram& error) {
      return error.what();
    }
    return "";
  }

  std::unique_ptr<KinematicModel> arm_;
  std::vector<RobotFile> files_;
};

TEST_F(RobotTool, OfAScriptIsThatOfTheCell) {
  EXPECT_EQ(refusal("set_tcp(", "set_tcp("), "");
  // The nozzle of irb_4600 is at (-45, 0, 387) mm over its flange.
  const std::string what =
      refusal("set_tcp(p[-0.045000, 0.000000, 0.387000", "set_tcp(p[-0.045000, 0.000000, 0.400000");
  EXPECT_NE(what.find("the tool is set to (-45.000, 0.000, 400.000) mm"), std::string::npos) << what;
  EXPECT_NE(what.find("expected (-45.000, 0.000, 387.000) mm"), std::string::npos) << what;
}

TEST_F(RobotTool, OfAScriptIsStatedBeforeTheTipMoves) {
  std::string& text = files_[0].text;
  const std::size_t at = text.find("  set_tcp(");
  const std::string line = text.substr(at, text.find('\n', at) + 1 - at);
  const std::string what = refusal(line, "");
  EXPECT_NE(
      what.find("the tip moves before set_tcp; expected set_tcp before it, of (-45.000, 0.000, 387.000) mm"),
      std::string::npos)
      << what;
}

/// What the cell file has on the flange of irb_4600.
class LoadOfTheCell : public RobotTool {
 protected:
  LoadOfTheCell() {
    std::string urdf = arm_->urdf();
    urdf.insert(urdf.find("</robot>"),
                "<link name=\"cell_flange\"><inertial><origin xyz=\"-0.01 0 0.0805\"/><mass value=\"12.5\"/>"
                "<inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/></inertial></link>"
                "<joint name=\"to_cell_flange\" type=\"fixed\"><parent link=\"tool0\"/>"
                "<child link=\"cell_flange\"/></joint>");
    arm_ = kinematicModelFromUrdf(urdf);
  }
};

TEST_F(LoadOfTheCell, IsThatOfAProgram) {
  EXPECT_EQ(refusal("set_tcp(", "set_tcp("), "");
  std::string what = refusal("set_payload(12.5", "set_payload(2.5");
  EXPECT_NE(
      what.find("the payload is set to 2.5 kg with its centre at (-10, 0, 80.5) mm; expected 12.5 kg with "
                "its centre at (-10, 0, 80.5) mm, that of the cell of"),
      std::string::npos)
      << what;
  what = refusal("load 12.5 -10 0 80.5", "load 2.5 -10 0 80.5");
  EXPECT_NE(what.find("the program's notes have a load of 2.5 kg"), std::string::npos) << what;
}

TEST_F(LoadOfTheCell, IsThatOfTheSettings) {
  NoProgress nobody;
  const Toolpath toolpath = test::twoLayers();
  const JointPath joints = planJointPath(toolpath, Eigen::Isometry3d::Identity(), *arm_, {}, nobody);
  const RobotMotion robot{*arm_, joints};
  RobotProgramSettings settings = withLoad();
  EXPECT_NO_THROW(
      robotProgram(toolpath, Eigen::Isometry3d::Identity(), {RobotLanguage::Krl, "part", settings}, &robot));
  settings.tool_mass_kg = 11.0;
  try {
    robotProgram(toolpath, Eigen::Isometry3d::Identity(), {RobotLanguage::Krl, "part", settings}, &robot);
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("expected 0, or 12.5 kg with its centre at (-10, 0, 80.5) mm"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(RobotTool, LoadOfAScriptIsThatOfItsNote) {
  const std::string what = refusal("set_payload(12.5", "set_payload(2.5");
  EXPECT_NE(what.find("the payload is set to 2.5 kg with its centre at (-10, 0, 80.5) mm; expected 12.5 kg"),
            std::string::npos)
      << what;
}

TEST_F(RobotTool, LoadOfAScriptNeedsItsNote) {
  const std::string what = refusal("  ## load 12.5 -10 0 80.5\n", "");
  EXPECT_NE(what.find("expected a note of this load"), std::string::npos) << what;
}

}  // namespace
}  // namespace lamina
