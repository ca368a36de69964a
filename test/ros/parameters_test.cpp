// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.hpp"

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <limits>

#include "lamina/base/error.hpp"

namespace {

struct Example {
  double height_mm = 0.2;
  int count = 2;
  bool is_on = false;
  std::string name = "gantry";
  std::vector<double> axis;
  lamina::SettingTable zones;
};

lamina::SettingsSchema describe(Example& example) {
  lamina::SettingsSchema schema;
  schema.number("slicing.height_mm", example.height_mm, lamina::Bounds::above(0.0, 10.0), "Height.");
  schema.integer("walls.count", example.count, {0.0, 100.0}, "Walls.");
  schema.flag("walls.on", example.is_on, "Whether there are walls.");
  schema.text("machine.name", example.name, "Machine.");
  schema.numbers("axis", example.axis, 3, "Axis.");
  schema.table("zones", example.zones, "Zones.");
  return schema;
}

/// What applying the parameters of one group in parameters.test throws; empty if it throws nothing.
std::string refusal(const std::string& group) {
  Example example;
  lamina::SettingsSchema schema = describe(example);
  try {
    lamina::applyParameters(schema, ros::NodeHandle("~" + group));
    return {};
  } catch (const lamina::InvalidConfig& error) {
    return error.what();
  }
}

TEST(Parameters, SetTheSettingsOfTheirKeys) {
  Example example;
  lamina::SettingsSchema schema = describe(example);
  lamina::applyParameters(schema, ros::NodeHandle("~good"));
  EXPECT_DOUBLE_EQ(example.height_mm, 0.3);
  EXPECT_EQ(example.count, 4);
  EXPECT_TRUE(example.is_on);
  EXPECT_EQ(example.name, "5");
}

TEST(Parameters, AreNoneWhereNothingIsSet) {
  EXPECT_TRUE(lamina::settingsFromParameters(ros::NodeHandle("~absent")).empty());
  EXPECT_EQ(refusal("absent"), "");
}

TEST(Parameters, OfAWholeNumberSetANumber) { EXPECT_EQ(refusal("whole_number"), ""); }

TEST(Parameters, OfUnknownKeysAreRefusedWithTheNearestOne) {
  const std::string message = refusal("unknown_key");
  EXPECT_NE(message.find("slicing.heigth_mm"), std::string::npos) << message;
  EXPECT_NE(message.find("slicing.height_mm"), std::string::npos) << message;
}

TEST(Parameters, OfAnotherTypeAreRefused) {
  EXPECT_NE(refusal("text_for_number"), "");
  EXPECT_NE(refusal("number_for_integer"), "");
  EXPECT_NE(refusal("number_for_text"), "");
  EXPECT_NE(refusal("number_for_flag"), "");
  EXPECT_NE(refusal("list"), "");
}

/// What stands in a file of settings stands on the parameter server when that file is loaded with rosparam.
TEST(Parameters, ThatAreListsAreReadAsInFilesOfSettings) {
  Example example;
  lamina::SettingsSchema schema = describe(example);
  lamina::applyParameters(schema, ros::NodeHandle("~list_of_numbers"));
  EXPECT_EQ(example.axis, (std::vector<double>{0.0, 0.5, -1.0}));
  EXPECT_EQ(example.name, "desk,motion");
  lamina::applyParameters(schema, ros::NodeHandle("~list_of_groups"));
  const lamina::SettingTable zones{
      {"0.file", "a.stl"}, {"0.flow", "0.5"}, {"1.corner", "1,2"}, {"1.file", "b.stl"}};
  EXPECT_EQ(example.zones, zones);
}

TEST(Parameters, ThatAreListsOfAnotherKindAreRefused) {
  EXPECT_NE(refusal("list").find("slicing.height_mm is '0.1,0.2'"), std::string::npos) << refusal("list");
  EXPECT_NE(refusal("list_of_too_few").find("axis is '0,1'; must be 3 numbers"), std::string::npos)
      << refusal("list_of_too_few");
  EXPECT_NE(refusal("list_for_flag"), "");
  EXPECT_NE(refusal("list_of_both").find("1 values and 1 groups"), std::string::npos)
      << refusal("list_of_both");
}

TEST(Parameters, OfTheLibraryOfDiagnosticsAreNoSettings) { EXPECT_EQ(refusal("diagnosed"), ""); }

TEST(Parameters, ThatYamlTakesForTruthValuesAreToBeQuoted) {
  const std::string message = refusal("word_for_text");
  EXPECT_NE(message.find("machine.name is 'false'"), std::string::npos) << message;
  EXPECT_NE(message.find("quotes"), std::string::npos) << message;
}

TEST(Parameters, OutOfRangeAreRefused) {
  const std::string message = refusal("out_of_range");
  EXPECT_NE(message.find("slicing.height_mm is '0'"), std::string::npos) << message;
}

}  // namespace
