// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/checked_bodies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "support/arms.hpp"

namespace lamina {
namespace {

std::string solidLink(const std::string& link, const std::string& origin, const std::string& geometry) {
  return "<link name=\"" + link + "\"><collision><origin xyz=\"" + origin + "\"/><geometry>" + geometry +
         "</geometry></collision></link>";
}

/// An arm whose flange stays in the fork of joint 4, and whose upper arm meets that fork when it is
/// stretched.
std::string forkedArm() {
  std::string text = test::railArm();
  const auto replace = [&text](const std::string& link, const std::string& solid) {
    const std::string bare = "<link name=\"" + link + "\"/>";
    text.replace(text.find(bare), bare.size(), solid);
  };
  replace("joint_2_link", solidLink("joint_2_link", "0 0 1.9", "<sphere radius=\"0.1\"/>"));
  replace("joint_4_link", solidLink("joint_4_link", "0 0 0.45", "<box size=\"0.3 0.3 0.3\"/>"));
  replace("joint_6_link", solidLink("joint_6_link", "0 0 0", "<sphere radius=\"0.02\"/>"));
  return text;
}

using LinkNames = std::vector<std::pair<std::string, std::string>>;

TEST(CheckedBodies, LeaveOutLinksThatAreBuiltIntoEachOther) {
  const auto arm = kinematicModelFromUrdf(forkedArm());
  EXPECT_TRUE(linkBodies(arm->urdf()).ignored.empty());
  EXPECT_EQ(checkedBodies(*arm).ignored, (LinkNames{{"joint_4_link", "joint_6_link"}}))
      << "the upper arm meets the fork at zero, but not in nearly all poses";
}

/// An arm whose shoulder, 150 mm beside axis 1, is in all its poses within a drum about this axis.
/// @param drum  link that is the drum: `fence` or `base_link`, both fixed to the root
std::string armWithin(const std::string& drum) {
  std::string text = test::railArm();
  const auto replace = [&text](const std::string& old, const std::string& by) {
    text.replace(text.find(old), old.size(), by);
  };
  replace("name=\"external_1\" type=\"prismatic\"", "name=\"to_base\" type=\"fixed\"");
  replace("</robot>", test::fixedJoint("fence", "room", "xyz=\"0 0 0\"") + "</robot>");
  replace("<link name=\"joint_2_link\"/>", solidLink("joint_2_link", "0 0 0", "<sphere radius=\"0.1\"/>"));
  replace("<link name=\"" + drum + "\"/>",
          solidLink(drum, "0 0 0.5", "<cylinder radius=\"0.3\" length=\"0.4\"/>"));
  return text;
}

TEST(CheckedBodies, LeaveOutNoFenceInWhichALinkAlwaysIs) {
  EXPECT_TRUE(checkedBodies(*kinematicModelFromUrdf(armWithin("fence"))).ignored.empty());
  EXPECT_EQ(checkedBodies(*kinematicModelFromUrdf(armWithin("base_link"))).ignored,
            (LinkNames{{"base_link", "joint_2_link"}}))
      << "the foot carries the link";
}

TEST(CheckedBodies, LeaveOutNothingOfAnArmWithoutContacts) {
  const auto arm = kinematicModelFromUrdf(test::railArm());
  EXPECT_TRUE(checkedBodies(*arm).ignored.empty());
}

}  // namespace
}  // namespace lamina
