// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_publisher/description_warning.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

constexpr char kGantry[] = "<?xml version=\"1.0\"?>\n<robot name=\"gantry\"><link name=\"bed\"/></robot>";

TEST(DescriptionWarning, NamesBothRobots) {
  EXPECT_EQ(descriptionWarning("<robot xmlns:xacro='http://a' name='irb_4600'/>", kGantry),
            "it describes the robot 'irb_4600'; expected 'gantry', the machine of this node");
  EXPECT_EQ(descriptionWarning("nothing", kGantry),
            "it describes the robot ''; expected 'gantry', the machine of this node");
}

TEST(DescriptionWarning, IsEmptyForAFullerDescriptionOfTheSameRobot) {
  EXPECT_EQ(descriptionWarning(kGantry, kGantry), "");
  EXPECT_EQ(descriptionWarning("<robot name=\"gantry\"><link name=\"bed\"/><link name=\"fence\"/></robot>",
                               kGantry),
            "");
}

}  // namespace
}  // namespace lamina
