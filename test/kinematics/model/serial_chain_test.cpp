// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/serial_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/link_motion.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// A bed on a turntable and a nozzle on a slide, with a wheel beside the slide.
std::string urdfWith(const std::string& wheel) {
  return "<robot name=\"lathe\"><link name=\"base\"/><link name=\"bed\"/><link name=\"nozzle\"/><link "
         "name=\"wheel\"/>"
         "<joint name=\"external_1\" type=\"continuous\"><parent link=\"base\"/><child link=\"bed\"/>"
         "<origin xyz=\"0.1 0 0\"/><axis xyz=\"0 0 1\"/><limit velocity=\"2\" effort=\"1\"/></joint>"
         "<joint name=\"z\" type=\"prismatic\"><parent link=\"base\"/><child link=\"nozzle\"/>"
         "<origin xyz=\"0 0 0.5\" rpy=\"3.14159265358979 0 0\"/><axis xyz=\"0 0 -1\"/>"
         "<limit lower=\"-0.1\" upper=\"0.2\" velocity=\"0.3\" effort=\"1\"/></joint>"
         "<joint name=\"spin\" type=\"continuous\"><parent link=\"nozzle\"/><child link=\"wheel\"/>"
         "<origin xyz=\"0.02 0 0\"/><axis xyz=\"1 0 0\"/><limit velocity=\"2\" effort=\"1\"/>" +
         wheel + "</joint></robot>";
}

SerialChain chainOf(const std::string& urdf) { return serialChain(*parseMachine(urdf), urdf); }

std::string serialChainFailureOf(const std::string& urdf) {
  try {
    chainOf(urdf);
    return "";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

const char* const kMimic = "<mimic joint=\"z\" multiplier=\"50\" offset=\"0.25\"/>";

TEST(SerialChain, RunsFromTheBedOverTheRootToTheNozzle) {
  const SerialChain chain = chainOf(urdfWith(kMimic));
  ASSERT_EQ(chain.joints.size(), 2U);
  EXPECT_EQ(chain.joints[0].name, "z") << "external ones are the last";
  EXPECT_EQ(chain.joints[0].low, -100.0);
  EXPECT_EQ(chain.joints[0].max_speed, 300.0);
  EXPECT_EQ(chain.outward, (std::vector<int>{1, 0}));
  // The table turns by a quarter: the nozzle, at -100 mm in x of the bed, goes the other way.
  const Eigen::Isometry3d pose = bedFromNozzle(chain, Eigen::Vector2d(20.0, M_PI_2));
  EXPECT_TRUE(pose.translation().isApprox(Point3(0, 100, 520), 1e-12));
  EXPECT_TRUE(pose.linear().col(2).isApprox(-Point3::UnitZ(), 1e-12));
}

TEST(SerialChain, AJointThatMimicsFollows) {
  const SerialChain chain = chainOf(urdfWith(kMimic));
  const Eigen::Vector2d values(20.0, 0.0);  // mm, rad
  EXPECT_NEAR(urdfJoints(chain, values).at("spin"), 1.25, 1e-12);
  const Eigen::Isometry3d wheel = bedFromLinks(chain, values).at("wheel");
  const Eigen::Isometry3d nozzle = bedFromNozzle(chain, values);
  EXPECT_TRUE((nozzle.inverse() * wheel).translation().isApprox(Point3(20, 0, 0), 1e-12));
  const Eigen::Matrix3d turned = (nozzle.inverse() * wheel).linear();
  EXPECT_TRUE(turned.isApprox(Eigen::AngleAxisd(1.25, Point3::UnitX()).toRotationMatrix(), 1e-12));
}

TEST(SerialChain, NothingElseMoves) {
  EXPECT_EQ(
      serialChainFailureOf(urdfWith("")),
      "machine 'lathe': joint 'spin' moves, but neither stands between bed and nozzle nor mimics one that "
      "does");
  std::string floating = urdfWith(kMimic);
  floating.replace(floating.find("\"prismatic\""), 11, "\"floating\"");
  EXPECT_EQ(serialChainFailureOf(floating),
            "machine 'lathe': joint 'z' is neither prismatic, revolute, continuous nor fixed");
}

}  // namespace
}  // namespace lamina
