// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/joint_clearance.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/random.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

/// An upright head on x, y and z that turns by `b` about y at the nozzle tip, with a plate for a bed and,
/// 200 mm from its middle, a post.
/// @param bodies  collision elements of the nozzle
std::string tippingHead(const std::string& bodies) {
  return R"(<robot name="tipping_head">
    <link name="base_link"><collision><origin xyz="0.2 0 0"/><geometry><box size="0.01 0.01 0.2"/></geometry></collision></link>
    <link name="bed"><collision><origin xyz="0 0 -0.005"/><geometry><box size="0.3 0.3 0.01"/></geometry></collision></link>
    <joint name="base_to_bed" type="fixed"><parent link="base_link"/><child link="bed"/></joint>
    <link name="beam"/><link name="carriage"/><link name="slide"/><link name="fork"/>
    <joint name="x" type="prismatic"><parent link="base_link"/><child link="beam"/><axis xyz="1 0 0"/>
      <limit lower="-0.3" upper="0.3" velocity="0.5" effort="1"/></joint>
    <joint name="y" type="prismatic"><parent link="beam"/><child link="carriage"/><axis xyz="0 1 0"/>
      <limit lower="-0.3" upper="0.3" velocity="0.5" effort="1"/></joint>
    <joint name="z" type="prismatic"><parent link="carriage"/><child link="slide"/><axis xyz="0 0 1"/>
      <limit lower="-0.3" upper="0.3" velocity="0.5" effort="1"/></joint>
    <joint name="b" type="revolute"><parent link="slide"/><child link="fork"/><axis xyz="0 1 0"/>
      <limit lower="-1.6" upper="1.6" velocity="1" effort="1"/></joint>
    <link name="nozzle">)" +
         bodies + R"(</link>
    <joint name="fork_to_nozzle" type="fixed"><parent link="fork"/><child link="nozzle"/>
      <origin rpy="3.14159265358979 0 0"/></joint>
  </robot>)";
}

/// A cone that stands on the tip, 30 mm high.
std::string jointClearanceConeOf(double half_angle) {
  return R"(<collision name="cone"><origin xyz="0 0 -0.015"/><geometry><cylinder radius=")" +
         std::to_string(0.03 * std::tan(half_angle)) + R"(" length="0.03"/></geometry></collision>)";
}

Path jointClearanceTravel(const std::vector<Point3>& points, double tilt = 0.0) {
  Path path = test::straightPath(points[0], points[1]);
  path.points = points;
  path.role = PathRole::Travel;
  path.bead = Bead{};
  path.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(tilt, Point3::UnitY())) * nozzleDown();
  return path;
}

Path wallAt(double x, double height) {
  Path wall = test::straightPath({x, -40, height}, {x, 40, height});
  wall.bead = Bead{1.0, height};
  return wall;
}

/// A wall of one bead, 1 mm wide, along y at that x, and a jointClearanceTravel that comes down beside it to
/// (0, 0, z) with the head tilted towards the wall.
Toolpath jointClearanceBesideWall(double x, double wall_height, double z, double tilt) {
  const Path wall = wallAt(x, wall_height);
  Path down = jointClearanceTravel({{0, 0, 100}, {0, 0, z}}, tilt);
  return {"wall",
          {{wall_height, wall_height, {wall, jointClearanceTravel({wall.lastPoint(), {0, 0, 100}}), down}}}};
}

JointPath jointsOf(const KinematicModel& model, const Toolpath& toolpath) {
  JointPath path;
  JointValues near = JointValues::Zero(static_cast<Eigen::Index>(model.joints().size()));
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p) {
      const Path& run = toolpath.layers[l].paths[p];
      for (std::size_t i = 0; i < run.points.size() + (run.is_closed ? 1 : 0); ++i) {
        const std::size_t w = i % run.points.size();
        const Eigen::Isometry3d pose = Eigen::Translation3d(run.points[w]) * run.orientation.at(w);
        path.at.push_back({l, p, w});
        path.values.push_back(near);
        double nearest = std::numeric_limits<double>::infinity();
        for (const InverseSolution& solution : model.solutions(pose, near)) {
          const double way = (solution.values - near).tail(1).norm();
          if (way < nearest) nearest = way, path.values.back() = solution.values;
        }
        near = path.values.back();
      }
    }
  return path;
}

JointClearanceReport jointClearanceChecked(const Toolpath& toolpath, const std::string& urdf) {
  const auto model = kinematicModelFromUrdf(urdf);
  const JointPath path = jointsOf(*model, toolpath);
  ClearanceSettings settings;
  settings.tolerance_mm = 0.0;
  NoProgress nobody;
  return checkJointClearance({toolpath, Eigen::Isometry3d::Identity(), *model, path}, linkBodies(urdf),
                             settings, nobody);
}

/// The tipping head with a beam that carries it past the post to +x, and past a fence to -x.
std::string beamBesideFence() {
  std::string text = tippingHead(
      R"(<collision><origin xyz="0 0 -0.2"/><geometry><sphere radius="0.001"/></geometry></collision>)");
  const std::string bare = R"(<link name="beam"/>)";
  return text.replace(text.find(bare), bare.size(), R"(
    <link name="fence"><collision><origin xyz="-0.2 0 0"/><geometry><box size="0.01 0.01 0.2"/></geometry></collision></link>
    <joint name="base_to_fence" type="fixed"><parent link="base_link"/><child link="fence"/></joint>
    <link name="beam"><collision><origin xyz="0 0 0.05"/><geometry><box size="0.02 0.02 0.02"/></geometry></collision></link>)");
}

TEST(JointClearance, TheFirstLinkThatMovesMeetsAFenceBesideTheLinkThatCarriesIt) {
  const auto movingTo = [](double x) {
    return jointClearanceChecked({"way", {{1.0, 1.0, {jointClearanceTravel({{0, 0, 50}, {x, 0, 50}})}}}},
                                 beamBesideFence());
  };
  const JointClearanceReport report = movingTo(-200.0);
  ASSERT_FALSE(report.collisions.empty());
  EXPECT_EQ(report.collisions.back().link, "beam");
  EXPECT_EQ(report.collisions.back().other, "fence");
  EXPECT_TRUE(movingTo(200.0).collisions.empty()) << "the beam slides on the link of the post";
}

TEST(JointClearance, ATiltedConeMeetsAWallWhereItsLeaningFlankDoes) {
  EXPECT_TRUE(rc::check("any half angle and tilt", [](std::uint64_t seed) {
    Random random(seed);
    const double half_angle = random.uniform(0.2, 0.6);
    const double tilt = random.uniform(0.0, 0.5);
    // The flank leans by tilt + half angle from the vertical; at the top of the wall, 10 mm, it is 10 - z
    // times the tangent of that out, as long as the cone is that long.
    const double gap = random.uniform(1.0, 5.0);
    const double limit = 10.0 - gap / std::tan(half_angle + tilt);
    RC_PRE(limit > 0.5 && 9.5 > limit);
    const std::string machine = tippingHead(jointClearanceConeOf(half_angle));
    RC_ASSERT(jointClearanceChecked(jointClearanceBesideWall(gap + 0.5, 10.0, limit + 0.01, tilt), machine)
                  .collisions.empty());
    const auto collisions =
        jointClearanceChecked(jointClearanceBesideWall(gap + 0.5, 10.0, limit - 0.01, tilt), machine)
            .collisions;
    RC_ASSERT(collisions.size() == 1U);
    RC_ASSERT(collisions[0].obstacle == Obstacle::Material);
    RC_ASSERT(collisions[0].at.path == 2U && collisions[0].at.waypoint == 1U);
    RC_ASSERT(collisions[0].deposited.path == 0U && collisions[0].link == "nozzle");
  }));
}

TEST(JointClearance, ATiltAwayFromAWallClearsIt) {
  const std::string machine = tippingHead(jointClearanceConeOf(0.5));
  EXPECT_EQ(jointClearanceChecked(jointClearanceBesideWall(1.0, 10.0, 5.0, 0.4), machine).collisions.size(),
            1U);
  EXPECT_TRUE(
      jointClearanceChecked(jointClearanceBesideWall(1.0, 10.0, 5.0, -0.5), machine).collisions.empty());
}

TEST(JointClearance, AHeadThatTipsIntoThePlateNamesTheBed) {
  // The flank of a cone of half angle 0.5 lies on the plate at a tilt of pi / 2 - 0.5.
  const Path clear = jointClearanceTravel({{0, 0, 0.01}, {20, 0, 0.01}}, M_PI / 2 - 0.5 - 0.01);
  const Path below = jointClearanceTravel({{0, 0, 0.01}, {20, 0, 0.01}}, M_PI / 2 - 0.5 + 0.01);
  EXPECT_TRUE(jointClearanceChecked({"tip", {{1, 1, {clear}}}}, tippingHead(jointClearanceConeOf(0.5)))
                  .collisions.empty());
  const auto collisions =
      jointClearanceChecked({"tip", {{1, 1, {below}}}}, tippingHead(jointClearanceConeOf(0.5))).collisions;
  ASSERT_EQ(collisions.size(), 2U) << "both waypoints";
  EXPECT_EQ(collisions[0].obstacle, Obstacle::Bed);
  EXPECT_EQ(collisions[0].link, "nozzle");
}

TEST(JointClearance, AHeadThatRunsIntoAPostNamesBothLinks) {
  const auto collisions =
      jointClearanceChecked({"post", {{1, 1, {jointClearanceTravel({{150, 0, 50}, {190, 0, 50}})}}}},
                            tippingHead(jointClearanceConeOf(0.5)))
          .collisions;
  ASSERT_EQ(collisions.size(), 1U);
  EXPECT_EQ(collisions[0].obstacle, Obstacle::Machine);
  EXPECT_EQ(collisions[0].link, "nozzle");
  EXPECT_EQ(collisions[0].other, "base_link");
  EXPECT_EQ(collisions[0].at.waypoint, 1U);
}

TEST(JointClearance, PlacesBetweenWaypointsAreLookedAt) {
  Toolpath toolpath = jointClearanceBesideWall(5.0, 10.0, 50.0, 0.0);
  toolpath.layers[0].paths.push_back(jointClearanceTravel({{0, 0, 50}, {-30, 0, 5}, {40, 0, 5}}));
  const auto collisions = jointClearanceChecked(toolpath, tippingHead(jointClearanceConeOf(0.3))).collisions;
  ASSERT_EQ(collisions.size(), 1U) << "it goes through the wall";
  EXPECT_EQ(collisions[0].at.path, 3U);
  EXPECT_EQ(collisions[0].at.waypoint, 2U);
}

TEST(JointClearance, WhatIsDepositedLaterIsNotThereYet) {
  Toolpath toolpath = jointClearanceBesideWall(2.0, 10.0, 5.0, 0.0);
  std::reverse(toolpath.layers[0].paths.begin(), toolpath.layers[0].paths.end());
  for (Path& path : toolpath.layers[0].paths) std::reverse(path.points.begin(), path.points.end());
  EXPECT_TRUE(jointClearanceChecked(toolpath, tippingHead(jointClearanceConeOf(0.5))).collisions.empty());
}

TEST(JointClearance, BeadsOfLayersThatBendLieBelowTheTipAlongTheToolAxis) {
  // A bead on a slope of 45 deg, 2 mm high, deposited with the tool axis into the slope: it reaches sqrt(2)
  // mm below and beside its line. A point of its box is met from below where one that hung straight down is
  // not.
  Path bead = test::straightPath({0, 0, 20}, {20, 0, 40});
  bead.bead = Bead{1.0, 2.0};
  bead.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(-M_PI / 4, Point3::UnitY())) * nozzleDown();
  const double inside = 1.0 / std::sqrt(2.0);
  const Path low = jointClearanceTravel({{10 + inside, 0, 10}, {10 + inside, 0, 30 - inside}});
  const Path between = jointClearanceTravel({bead.lastPoint(), {60, 0, 60}, {60, 0, 10}, low.firstPoint()});
  const auto collisions = jointClearanceChecked({"slope", {{40, 2, {bead, between, low}}}},
                                                tippingHead(jointClearanceConeOf(0.1)))
                              .collisions;
  ASSERT_FALSE(collisions.empty());
  EXPECT_EQ(collisions.back().obstacle, Obstacle::Material);
  EXPECT_EQ(collisions.back().at.path, 2U);
}

TEST(JointClearance, WhatTheNozzleHasJustLeftIsSoftAndWhatItComesBackToIsNot) {
  // A rod of 1 mm that reaches half a millimetre below the tip: it stands in what it lays.
  const std::string machine = tippingHead(
      R"(<collision><origin xyz="0 0 -0.0095"/><geometry><cylinder radius="0.0005" length="0.02"/></geometry></collision>)");
  Path bead = test::straightPath({0, 0, 20}, {20, 0, 20});
  bead.points.clear();
  for (int x = 0; x <= 20; ++x) bead.points.emplace_back(x, 0, 20);
  bead.bead = Bead{2.0, 1.0};
  EXPECT_TRUE(jointClearanceChecked({"leave", {{20, 1, {bead}}}}, machine).collisions.empty());
  const Path back = jointClearanceTravel({{20, 0, 20}, {12, 0, 20}});
  EXPECT_EQ(jointClearanceChecked({"back", {{20, 1, {bead, back}}}}, machine).collisions.size(), 1U);
}

TEST(JointClearance, WaypointsWithoutJointValuesAreLeftOut) {
  const std::string urdf = tippingHead(jointClearanceConeOf(0.5));
  const auto model = kinematicModelFromUrdf(urdf);
  const Toolpath toolpath = jointClearanceBesideWall(1.0, 10.0, 5.0, 0.4);
  JointPath path = jointsOf(*model, toolpath);
  path.values.back() = JointValues();
  NoProgress nobody;
  const JointClearanceReport report = checkJointClearance(
      {toolpath, Eigen::Isometry3d::Identity(), *model, path}, linkBodies(urdf), ClearanceSettings(), nobody);
  EXPECT_TRUE(report.collisions.empty());
  EXPECT_EQ(report.waypoints, path.values.size() - 1);
}

/// Beads that reach down to the bed, one a layer, at any place and of any height, with travels between them.
Toolpath jointClearanceLayers(Random& random, int count) {
  Toolpath toolpath;
  Point3 last(0, 0, 100);
  for (int i = 0; i < count; ++i) {
    const double height = random.uniform(2.0, 30.0);
    const Point3 from(random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0), height);
    Path bead = test::straightPath(from, {random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0), height});
    bead.bead = Bead{1.0, height};
    bead.is_closed = i % 3 == 0;
    const Path travel =
        jointClearanceTravel({last, {last.x(), last.y(), 100}, {from.x(), from.y(), 100}, from});
    toolpath.layers.push_back({height, height, {travel, bead}});
    last = bead.lastPoint();
  }
  return toolpath;
}

TEST(JointClearance, LayersThatTheJointPathLeavesOutStandInTheWayAllTheSame) {
  EXPECT_TRUE(rc::check("any layers of any toolpath", [](std::uint64_t seed) {
    Random random(seed);
    const std::string urdf = tippingHead(jointClearanceConeOf(0.5));
    const auto model = kinematicModelFromUrdf(urdf);
    const Toolpath toolpath = jointClearanceLayers(random, 12);
    std::vector<char> is_looked_at;
    for (int i = 0; i < 12; ++i) is_looked_at.push_back(random.uniform(0.0, 1.0) < 0.5 ? 1 : 0);
    const JointPath whole = jointsOf(*model, toolpath);
    JointPath some;
    for (std::size_t s = 0; s < whole.at.size(); ++s) {
      if (is_looked_at[whole.at[s].layer] == 0) continue;
      some.at.push_back(whole.at[s]);
      some.values.push_back(whole.values[s]);
    }
    NoProgress nobody;
    const auto collisionsOn = [&](const JointPath& path) {
      return checkJointClearance({toolpath, Eigen::Isometry3d::Identity(), *model, path}, linkBodies(urdf),
                                 {}, nobody)
          .collisions;
    };
    std::vector<Collision> expected = collisionsOn(whole);
    expected.erase(std::remove_if(expected.begin(), expected.end(),
                                  [&](const Collision& each) { return is_looked_at[each.at.layer] == 0; }),
                   expected.end());
    const std::vector<Collision> found = collisionsOn(some);
    RC_ASSERT(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      RC_ASSERT(found[i].at == expected[i].at && found[i].deposited == expected[i].deposited);
      RC_ASSERT(found[i].tip == expected[i].tip);
    }
  }));
}

TEST(JointClearance, AMachineWithoutBodiesIsRefused) {
  EXPECT_THROW(jointClearanceChecked(jointClearanceBesideWall(1.0, 10.0, 5.0, 0.0), tippingHead("")),
               InvalidConfig);
}

TEST(JointClearance, IsTheSameWhateverTheThreads) {
  const Toolpath toolpath = jointClearanceBesideWall(1.0, 10.0, 5.0, 0.4);
  const auto many = jointClearanceChecked(toolpath, tippingHead(jointClearanceConeOf(0.5))).collisions;
  const ThreadLimit limit(1);
  const auto one = jointClearanceChecked(toolpath, tippingHead(jointClearanceConeOf(0.5))).collisions;
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].tip, many[i].tip);
}

}  // namespace
}  // namespace lamina
