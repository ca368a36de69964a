// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Which logical axes of the controller external joints are.
#include "program/rapid/rapid_externals.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "program/rapid/writer/rapid_lines.hpp"
#include "support/rapid_programs.hpp"
#include "support/tilting_arm.hpp"

namespace lamina {
namespace {

std::string refusalOfExternals(const std::string& text) {
  try {
    externalsOf(*kinematicModelFromUrdf(test::tiltingArm()), text);
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return "";
}

TEST(RapidExternals, AreJointsWithAxesSensesAndZeros) {
  const std::vector<RapidExternal> externals =
      rapidExternals("external_1=eax_b, external_2 = -EAX_C+90.5,external_3=eax_f-20");
  ASSERT_EQ(externals.size(), 3U);
  EXPECT_EQ(externals[0].joint, "external_1");
  EXPECT_EQ(externals[0].slot, 1U);
  EXPECT_EQ(externals[0].sign, 1.0);
  EXPECT_EQ(externals[0].zero, 0.0);
  EXPECT_EQ(externals[1].joint, "external_2");
  EXPECT_EQ(externals[1].slot, 2U);
  EXPECT_EQ(externals[1].sign, -1.0);
  EXPECT_EQ(externals[1].zero, 90.5);
  EXPECT_EQ(externals[2].slot, 5U);
  EXPECT_EQ(externals[2].zero, -20.0);
  EXPECT_TRUE(rapidExternals("").empty());
  for (const char* wrong : {"external_1", "external_1=eax_g", "external_1=eax_", "=eax_a",
                            "external_1=eax_b+", "external_1=eax_b90", "external_1=eax_b+1e9",
                            "external_1=eax_b,external_2=eax_b", "external_1=eax_b,external_1=eax_c"})
    EXPECT_THROW(rapidExternals(wrong), InvalidConfig) << wrong;
}

TEST(RapidExternals, AreThoseOfTheArmInItsOrder) {
  const auto arm = kinematicModelFromUrdf(test::tiltingArm());
  const std::vector<RapidExternal> externals = externalsOf(*arm, "external_2=eax_c,external_1=-eax_d");
  ASSERT_EQ(externals.size(), 2U);
  EXPECT_EQ(externals[0].slot, 3U);
  EXPECT_EQ(externals[1].slot, 2U);
  EXPECT_TRUE(externalsOf(*arm, "").empty());
  EXPECT_NE(refusalOfExternals("external_1=eax_b").find("without joint external_2"), std::string::npos);
  EXPECT_NE(
      refusalOfExternals("external_1=eax_b,external_2=eax_c,external_9=eax_d").find("names joint external_9"),
      std::string::npos);
}

TEST(RapidExternals, StandAtTheirAxesOfATarget) {
  RapidSettings settings;
  settings.external_map = {{"external_1", 1, 1.0, 0.0}, {"external_2", 3, -1.0, 90.0}};
  EXPECT_EQ(rapidExternalAxes({1200.0, 30.0}, settings), "[9e+09,1200.000,9e+09,60.000,9e+09,9e+09]");
  settings.external_map.clear();
  EXPECT_EQ(rapidExternalAxes({1200.0, 30.0}, settings), "[1200.000,30.000,9e+09,9e+09,9e+09,9e+09]");
}

TEST(RapidExternals, AreRefusedWhereNoJointIsKnown) {
  Path path;
  path.role = PathRole::OuterWall;
  path.points = {{0, 0, 1}, {10, 0, 1}};
  path.orientation = AlongPath<Eigen::Quaterniond>(nozzleDown());
  path.bead = Bead{2.0, 1.0};
  path.feed_mm_s = 10.0;
  Toolpath toolpath;
  toolpath.layers.push_back({1.0, 1.0, {path}});
  RapidSettings settings;
  settings.external_axes = "external_1=eax_b";
  EXPECT_THROW(test::rapidModules(toolpath, settings), InvalidConfig);
  settings.external_axis = 5.0;
  EXPECT_THROW(checkedRapidSettings(settings), InvalidConfig);
  settings.external_axis = 0.0;
  settings.is_thesis_compatible = true;
  EXPECT_NO_THROW(checkedRapidSettings(settings));
  settings.external_axes = "external_1=eax_f";
  EXPECT_THROW(checkedRapidSettings(settings), InvalidConfig);
}

}  // namespace
}  // namespace lamina
