// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/link_bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {
namespace {

std::size_t groupOf(const LinkBodies& bodies, const std::string& link) {
  for (std::size_t g = 0; g < bodies.groups.size(); ++g) {
    const std::vector<std::string>& links = bodies.groups[g].links;
    if (std::find(links.begin(), links.end(), link) != links.end()) return g;
  }
  throw InvalidInput("no group holds the link " + link);
}

bool canMeet(const LinkBodies& bodies, const std::string& a, const std::string& b) {
  std::pair<std::size_t, std::size_t> pair{groupOf(bodies, a), groupOf(bodies, b)};
  if (pair.first > pair.second) std::swap(pair.first, pair.second);
  return std::find(bodies.pairs.begin(), bodies.pairs.end(), pair) != bodies.pairs.end() &&
         !areUnchecked(bodies, a, b);
}

TEST(LinkBodies, LinksJoinedFirmlyAreOneGroup) {
  const LinkBodies bodies = linkBodies(machineByName("cartesian_gantry").urdf);
  EXPECT_EQ(groupOf(bodies, "nozzle"), groupOf(bodies, "head"));
  EXPECT_EQ(groupOf(bodies, "sensor"), groupOf(bodies, "head"));
  EXPECT_EQ(groupOf(bodies, "bed"), bodies.bed);
  EXPECT_NE(groupOf(bodies, "carriage"), groupOf(bodies, "head"));
}

TEST(LinkBodies, LinksOfAUniversalJointAreNoPair) {
  const LinkBodies bodies = linkBodies(kinematicModelByName("rus_platform")->urdf());
  EXPECT_FALSE(canMeet(bodies, "crank_1", "coupler_1"));
  EXPECT_TRUE(canMeet(bodies, "crank_1", "coupler_end_1")) << "the far end of the coupler";
  EXPECT_TRUE(canMeet(bodies, "crank_1", "coupler_2"));
  EXPECT_TRUE(canMeet(bodies, "coupler_1", "mobile_platform"));
}

TEST(LinkBodies, LinksThatHangOnEachOtherAreNoPair) {
  const std::string urdf = R"(<robot name="chain">
    <link name="bed"><collision><geometry><box size="1 1 1"/></geometry></collision></link>
    <link name="upper"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
    <link name="lower"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
    <link name="bare"/>
    <joint name="one" type="revolute"><parent link="bed"/><child link="upper"/><axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
    <joint name="two" type="revolute"><parent link="upper"/><child link="lower"/><axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
    <joint name="three" type="revolute"><parent link="lower"/><child link="bare"/><axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>)";
  const LinkBodies bodies = linkBodies(urdf);
  EXPECT_FALSE(canMeet(bodies, "bed", "upper"));
  EXPECT_FALSE(canMeet(bodies, "upper", "lower"));
  EXPECT_TRUE(canMeet(bodies, "bed", "lower"));
  EXPECT_FALSE(canMeet(bodies, "bed", "bare")) << "it has no body";
}

TEST(LinkBodies, WhatIsFixedBesideAJointIsNoNeighbourOfWhatThisMoves) {
  const std::string body = "<collision><geometry><sphere radius=\"0.1\"/></geometry></collision></link>";
  const auto joint = [](const std::string& type, const std::string& parent, const std::string& child) {
    return "<joint name=\"to_" + child + "\" type=\"" + type + "\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/><axis xyz=\"1 0 0\"/><limit lower=\"-1\" upper=\"1\" " +
           "velocity=\"1\" effort=\"1\"/></joint>";
  };
  std::string urdf = "<robot name=\"cell\"><link name=\"world\"/>";
  for (const char* link : {"bed", "fence", "base", "upper", "lower", "tool"})
    urdf += std::string("<link name=\"") + link + "\">" + body;
  urdf += joint("fixed", "world", "bed") + joint("fixed", "world", "fence") +
          joint("prismatic", "world", "base") + joint("prismatic", "base", "upper") +
          joint("prismatic", "upper", "lower") + joint("fixed", "lower", "tool") + "</robot>";
  const LinkBodies bodies = linkBodies(urdf);
  using Names = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(uncheckedLinks(bodies), (Names{{"base", "upper"}, {"upper", "lower"}}));
  EXPECT_TRUE(canMeet(bodies, "fence", "base")) << "a carriage drives into a fence beside its rail";
  EXPECT_TRUE(canMeet(bodies, "bed", "base"));
  EXPECT_TRUE(canMeet(bodies, "upper", "tool")) << "the tool hangs on the link that the joint moves";
  EXPECT_FALSE(canMeet(bodies, "base", "upper"));
}

TEST(LinkBodies, ShapesAndPlacesAreThoseOfTheDescription) {
  const LinkBodies bodies = linkBodies(machineByName("gantry_45").urdf);
  const auto& all = bodies.groups[groupOf(bodies, "nozzle")].bodies;
  const auto cone = std::find_if(all.begin(), all.end(), [](const LinkBody& body) {
    return body.link == "nozzle" && std::holds_alternative<ConeShape>(body.shape);
  });
  ASSERT_NE(cone, all.end());
  EXPECT_NEAR(std::get<ConeShape>(cone->shape).length_mm, 5.0, 1e-9);
  EXPECT_TRUE(cone->link_from_body.translation().isApprox(Point3(0, 0, -2.5)));
}

TEST(LinkBodies, ADescriptionWithoutABedIsRefused) {
  EXPECT_THROW(linkBodies(R"(<robot name="none"><link name="table"/></robot>)"), InvalidConfig);
}

}  // namespace
}  // namespace lamina
