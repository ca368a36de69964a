// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/self_collision_guard.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "support/arms.hpp"
#include "verification/collision/solid.hpp"

namespace lamina {
namespace {

constexpr double kDegree = M_PI / 180.0;
/// Half a cell, 1 deg, of each of two joints moves no point of the heads by more: they are within 0.7 m of
/// either axis. It is asked twice: the cell may be half a cell from the values, and its margin is as great.
constexpr double kCellMotion = 2.0 * 2.0 * 700.0 * kDegree;

JointValues atDegrees(double fourth, double fifth, double sixth) {
  JointValues values = JointValues::Zero(6);
  values.tail<3>() = kDegree * Eigen::Vector3d(fourth, fifth, sixth);
  return values;
}

/// Whether any two groups are nearer to each other than the margin [mm], at 0 in each other.
bool isWithin(const KinematicModel& arm, const LinkBodies& bodies, const JointValues& values, double margin) {
  const auto links = arm.bedFromLinks(values);
  for (const auto& [a, b] : bodies.pairs)
    for (const LinkBody& one : bodies.groups[a].bodies)
      for (const LinkBody& other : bodies.groups[b].bodies)
        if (Solid(one.shape).meets(Solid(grown(other.shape, margin)),
                                   links.at(other.link) * other.link_from_body,
                                   links.at(one.link) * one.link_from_body))
          return true;
  return false;
}

/// The groups of two links alone.
LinkBodies only(LinkBodies bodies, const std::string& one, const std::string& other) {
  const auto has = [&](std::size_t group, const std::string& link) {
    const auto& links = bodies.groups[group].links;
    return std::find(links.begin(), links.end(), link) != links.end();
  };
  std::vector<std::pair<std::size_t, std::size_t>> kept;
  for (const auto& pair : bodies.pairs)
    if (has(pair.first, one) && has(pair.second, other)) kept.push_back(pair);
  bodies.pairs = kept;
  return bodies;
}

class Arms : public testing::TestWithParam<std::string> {};

TEST_P(Arms, NeverStandWithTheHeadInTheForearm) {
  const auto arm = kinematicModelByName(GetParam());
  const LinkBodies bodies = only(linkBodies(arm->urdf()), "link_4", "nozzle");
  ASSERT_EQ(bodies.pairs.size(), 1U);
  const SelfCollisionGuard guard(*arm, bodies);
  std::size_t banned = 0;
  EXPECT_TRUE(rc::check([&] {
    JointValues values = JointValues::Zero(static_cast<Eigen::Index>(arm->joints().size()));
    for (Eigen::Index j = 3; j < 6; ++j) {
      const DrivenJoint& joint = arm->joints()[static_cast<std::size_t>(j)];
      values[j] = joint.low + 1e-3 * *rc::gen::inRange(0, 1001) * (joint.high - joint.low);
    }
    if (guard.allows(values)) {
      RC_ASSERT(!isWithin(*arm, bodies, values, 0.0));
    } else {
      ++banned;
      RC_ASSERT(isWithin(*arm, bodies, values, kCellMotion));
    }
  }));
  EXPECT_GT(banned, 0U);
}

INSTANTIATE_TEST_SUITE_P(Robots, Arms, testing::Values("irb_4400", "irb_4600"));

TEST(SelfCollisionGuard, NamesTheLinks) {
  const auto arm = kinematicModelByName("irb_4600");
  const LinkBodies bodies = only(linkBodies(arm->urdf()), "link_4", "nozzle");
  const SelfCollisionGuard guard(*arm, bodies);
  for (double sixth = -180.0; sixth < 180.0; sixth += 1.0)
    for (const double fifth : {-110.0, 110.0}) {
      const JointValues values = atDegrees(0.0, fifth, sixth);
      if (!isWithin(*arm, bodies, values, 0.0)) continue;
      EXPECT_EQ(guard.hindrance(values), "link 'link_6' or 'nozzle' would be in link 'link_4'");
      return;
    }
  FAIL() << "the head never meets the forearm";
}

/// An arm with a counterweight 0.6 m behind its axis 1, and a post 0.6 m from that axis at 120 deg.
std::string armBesideAPost() {
  std::string text = test::exactParallelAxesArm().urdf();
  const auto solid = [&](const std::string& link, const std::string& xyz, const std::string& size) {
    const std::string empty = "<link name=\"" + link + "\"/>";
    text.replace(text.find(empty), empty.size(),
                 "<link name=\"" + link + "\"><collision><origin xyz=\"" + xyz +
                     "\"/><geometry><box size=\"" + size + "\"/></geometry></collision></link>");
  };
  solid("base_link", "0 0 0.05", "0.2 0.2 0.1");
  solid("joint_1_link", "-0.3 0 0.1", "0.7 0.1 0.1");
  const std::string end = "</robot>";
  text.replace(text.find(end), end.size(),
               test::fixedJoint("post", "base_link", "xyz=\"-0.3 0.5196 0\"") + end);
  solid("post", "0 0 0.5", "0.1 0.1 1");
  return text;
}

// The counterweight is over the post where joint 1 is at 120 - 180 = -60 deg. Its corners are 11 deg further
// from there, those of the post 7 deg, seen from the axis.
TEST(SelfCollisionGuard, KeepsTheFirstLinkOffWhatStandsBesideTheArm) {
  const auto arm = kinematicModelFromUrdf(armBesideAPost());
  const LinkBodies bodies = linkBodies(arm->urdf());
  const SelfCollisionGuard guard(*arm, bodies);
  JointValues values = JointValues::Zero(6);
  for (const double degrees : {-60.0, -50.0, -70.0, 300.0}) {
    values[0] = degrees * kDegree;
    EXPECT_FALSE(guard.allows(values)) << degrees;
    EXPECT_EQ(guard.hindrance(values), "link 'joint_1_link' would be in link 'post'") << degrees;
  }
  for (const double degrees : {0.0, -30.0, -90.0, 120.0, 180.0}) {
    values[0] = degrees * kDegree;
    EXPECT_TRUE(guard.allows(values)) << degrees << ": " << guard.hindrance(values);
  }
  for (int degrees = -180; degrees < 180; ++degrees) {
    values[0] = degrees * kDegree;
    if (isWithin(*arm, bodies, values, 0.0)) {
      EXPECT_FALSE(guard.allows(values)) << degrees;
    }
  }
}

TEST(SelfCollisionGuard, KnowsWholeTurns) {
  const auto arm = kinematicModelByName("irb_4600");
  const SelfCollisionGuard guard(*arm, linkBodies(arm->urdf()));
  for (double fifth = -120.0; fifth < 120.0; fifth += 7.0)
    for (double sixth = -180.0; sixth < 180.0; sixth += 7.0)
      EXPECT_EQ(guard.allows(atDegrees(0.0, fifth, sixth)),
                guard.allows(atDegrees(0.0, fifth, sixth + 360.0)));
}

TEST(SelfCollisionGuard, LetsAMachineAloneThatCannotHitItselfByTwoRotaryJoints) {
  const auto machine = kinematicModelByName("cartesian_gantry");
  const SelfCollisionGuard guard(*machine, linkBodies(machine->urdf()));
  EXPECT_TRUE(guard.allows(JointValues::Constant(3, 100.0)));
}

}  // namespace
}  // namespace lamina
