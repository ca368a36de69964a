// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/description_files/robot_description.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "support/arms.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

namespace fs = std::filesystem;

/// A folder of its own that goes with the test.
class VendorFolder : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_.file("vendor_support/urdf"));
    fs::create_directories(folder_.file("vendor_support/meshes"));
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.file(name)) << text;
  }

  std::string read(const std::string& text) const {
    return robotDescription(text, folder_.file("vendor_support/urdf/arm.urdf"));
  }

  std::string failureOf(const std::string& text) const {
    try {
      read(text);
      return "";
    } catch (const InvalidConfig& error) {
      return error.what();
    }
  }

  const test::ScratchFolder folder_;
};

std::string withMesh(const std::string& name) {
  return "<robot name=\"r\"><link name=\"base_link\"><collision><geometry><mesh filename=\"" + name +
         "\"/></geometry></collision></link></robot>";
}

TEST_F(VendorFolder, PackagesAreFoundByTheirNameOrThatOfTheirFolder) {
  write("vendor_support/meshes/base.stl", "");
  const std::string place = "file://" + folder_.file("vendor_support/meshes/base.stl");
  EXPECT_NE(read(withMesh("package://vendor_support/meshes/base.stl")).find(place), std::string::npos);
  EXPECT_NE(read(withMesh("../meshes/base.stl")).find(place), std::string::npos);
  write("vendor_support/package.xml", "<package><name>other_support</name></package>");
  EXPECT_NE(read(withMesh("package://other_support/meshes/base.stl")).find(place), std::string::npos);
  const std::string failure = failureOf(withMesh("package://vendor_support/meshes/base.stl"));
  EXPECT_NE(
      failure.find("link 'base_link' (line 1) has the collision mesh "
                   "'package://vendor_support/meshes/base.stl', whose package is in none of the folders"),
      std::string::npos)
      << failure;
}

TEST_F(VendorFolder, AllFaultsAreNamedAtOnce) {
  const std::string failure = failureOf(R"(<robot name="r">
    <link name="base_link"><collision><geometry><mesh filename="base.dae"/></geometry></collision></link>
    <link name="one"/>
    <link name="two"/>
    <link name="lost"/>
    <joint name="a" type="revolute"><parent link="base_link"/><child link="one"/><axis xyz="0 0 2"/></joint>
    <joint name="b" type="revolute"><parent link="one"/><child link="two"/><axis xyz="0 0 1"/>
      <limit lower="1" upper="-1" velocity="0" effort="1"/></joint>
    <joint name="c" type="floating"><parent link="nowhere"/><child link="two"/></joint></robot>)");
  for (const char* part :
       {"has 9 faults: ", "line 2) has the collision mesh 'base.dae', which is COLLADA",
        "joint 'a' (line 6) has the axis '0 0 2'", "joint 'a' (line 6) has no limits",
        "joint 'b' (line 7) has a velocity of 0; must be positive",
        "joint 'b' (line 7) has limits '1' to '-1'", "joint 'c' (line 9) is of type 'floating'",
        "has the parent 'nowhere', which is no link",
        "has the child 'two', which hangs on another joint, too", "links 'base_link', 'lost' hang on none"})
    EXPECT_NE(failure.find(part), std::string::npos) << part << "\nin\n" << failure;
}

TEST_F(VendorFolder, XacroIsRefusedWithWhatExpandsIt) {
  const std::string failure = failureOf(
      "<robot name=\"r\" xmlns:xacro=\"http://ros.org/wiki/xacro\"><xacro:arm prefix=\"\"/></robot>");
  EXPECT_NE(failure.find("is xacro; expected URDF, as `lamina expand "), std::string::npos) << failure;
}

TEST_F(VendorFolder, JointsHaveAnyNamesAndCountByTheChain) {
  std::string text = test::exactParallelAxesArm().urdf();
  const char* const names[] = {"wrist_z", "shoulder_pan", "a1", "elbow", "B", "zero"};
  for (int j = 0; j < 6; ++j) {
    const std::string plain = "name=\"joint_" + std::to_string(j + 1) + "\"";
    text.replace(text.find(plain), plain.size(), std::string("name=\"") + names[j] + "\"");
  }
  const auto renamed = kinematicModelFromUrdf(read(text));
  const auto plain = kinematicModelFromUrdf(test::exactParallelAxesArm().urdf());
  for (std::size_t j = 0; j < 6; ++j) EXPECT_EQ(renamed->joints()[j].name, names[j]);
  const JointValues values = JointValues::LinSpaced(6, -1.0, 1.3);
  EXPECT_LT(test::distance(renamed->bedFromNozzle(values), plain->bedFromNozzle(values)), 1e-12);
}

TEST_F(VendorFolder, JointsThatMimicNeedNoLimits) {
  std::string text = test::exactParallelAxesArm().urdf();
  text.insert(
      text.find("</robot>"),
      "<link name=\"piston\"/><joint name=\"lever\" type=\"revolute\"><parent link=\"base_link\"/>"
      "<child link=\"piston\"/><axis xyz=\"0 1 0\"/><mimic joint=\"joint_2\" multiplier=\"-1\"/></joint>");
  const auto arm = kinematicModelFromUrdf(read(text));
  EXPECT_NEAR(arm->urdfJoints(JointValues::Constant(6, 0.5)).at("lever"), -0.5, 1e-12);
}

}  // namespace
}  // namespace lamina
