// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/fence_distance.hpp"

#include <gtest/gtest.h>

#include <string>

#include "lamina/base/random.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

/// A ball of 20 mm at the tip of a machine of three linear axes, and two fences: a post whose face is at x =
/// 195 mm, and a ball of 50 mm at (0, 300, 100) mm.
constexpr char kFenced[] = R"(<robot name="fenced">
    <link name="base_link"/><link name="beam"/><link name="carriage"/><link name="nozzle">
      <collision><geometry><sphere radius="0.02"/></geometry></collision></link>
    <link name="bed"><collision><origin xyz="0 0 -0.005"/><geometry><box size="0.3 0.3 0.01"/></geometry></collision></link>
    <joint name="base_to_bed" type="fixed"><parent link="base_link"/><child link="bed"/></joint>
    <link name="cell_bodies">
      <collision><origin xyz="0.2 0 0"/><geometry><box size="0.01 0.01 2"/></geometry></collision>
      <collision><origin xyz="0 0.3 0.1"/><geometry><sphere radius="0.05"/></geometry></collision></link>
    <joint name="base_to_bodies" type="fixed"><parent link="base_link"/><child link="cell_bodies"/></joint>
    <joint name="x" type="prismatic"><parent link="base_link"/><child link="beam"/><axis xyz="1 0 0"/>
      <limit lower="-0.3" upper="0.3" velocity="0.5" effort="1"/></joint>
    <joint name="y" type="prismatic"><parent link="beam"/><child link="carriage"/><axis xyz="0 1 0"/>
      <limit lower="-0.3" upper="0.3" velocity="0.5" effort="1"/></joint>
    <joint name="z" type="prismatic"><parent link="carriage"/><child link="head"/><axis xyz="0 0 1"/>
      <limit lower="-0.3" upper="0.3" velocity="0.5" effort="1"/></joint>
    <link name="head"/>
    <joint name="head_to_nozzle" type="fixed"><parent link="head"/><child link="nozzle"/>
      <origin rpy="3.14159265358979 0 0"/></joint>
  </robot>)";

class FenceDistanceTest : public testing::Test {
 protected:
  std::optional<FenceDistance> along(const std::vector<Point3>& tips,
                                     const std::vector<JointPassage>& passages = {},
                                     const std::string& urdf = kFenced) const {
    const auto model = kinematicModelFromUrdf(urdf);
    Path path = test::straightPath(tips.front(), tips.back());
    path.points = tips;
    const Toolpath toolpath{"way", {{0.2, 0.2, {path}}}};
    JointPath joints;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      joints.at.push_back({0, 0, i});
      joints.values.push_back(tips[i]);
    }
    return nearestToFences({toolpath, Eigen::Isometry3d::Identity(), *model, joints}, passages,
                           linkBodies(urdf));
  }
};

TEST_F(FenceDistanceTest, IsThatOfTheNearestPlace) {
  const auto nearest = along({{0, 0, 0}, {100, 0, 0}, {150, 0, 0}, {50, 0, 0}});
  ASSERT_TRUE(nearest);
  EXPECT_NEAR(nearest->distance_mm, 195.0 - 150.0 - 20.0, 1e-3);
  EXPECT_EQ(nearest->link, "nozzle");
  EXPECT_EQ(nearest->body, 0U);
  EXPECT_EQ(nearest->at.waypoint, 2U);
}

TEST_F(FenceDistanceTest, NamesTheBodyAndIsZeroInIt) {
  const auto ball = along({{0, 0, 100}, {0, 200, 100}});
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->distance_mm, 100.0 - 50.0 - 20.0, 1e-3);
  EXPECT_EQ(ball->body, 1U);
  EXPECT_EQ(along({{0, 0, 0}, {190, 0, 0}})->distance_mm, 0.0);
}

TEST_F(FenceDistanceTest, CountsWaysBesideThePart) {
  JointPassage beside;
  beside.before = 0;
  beside.values = {JointValues(Point3(-20, 0, 0)), JointValues(), JointValues(Point3(170, 0, 0))};
  const auto nearest = along({{0, 0, 0}, {10, 0, 0}}, {beside});
  ASSERT_TRUE(nearest);
  EXPECT_NEAR(nearest->distance_mm, 5.0, 1e-3);
  EXPECT_EQ(nearest->at.waypoint, 0U);
}

TEST_F(FenceDistanceTest, LooksAwayOnlyWhereNothingCanBeNearer) {
  Random random(7);
  std::vector<Point3> tips;
  double least_mm = 1e9;
  for (int i = 0; i < 300; ++i) {
    tips.emplace_back(random.uniform(-150.0, 170.0), random.uniform(-100.0, 220.0),
                      random.uniform(0.0, 200.0));
    const Point3& tip = tips.back();
    const Point3 off(std::max(std::abs(tip.x() - 200.0) - 5.0, 0.0), std::max(std::abs(tip.y()) - 5.0, 0.0),
                     0.0);
    least_mm = std::min({least_mm, off.norm() - 20.0, (tip - Point3(0, 300, 100)).norm() - 70.0});
  }
  EXPECT_NEAR(along(tips)->distance_mm, std::max(0.0, least_mm), 1e-2);
}

TEST_F(FenceDistanceTest, IsNoneWithoutFencesOrWithIgnoredOnes) {
  std::string open = kFenced;
  open.replace(open.find("cell_bodies"), 11, "some_bodies");
  open.replace(open.find("cell_bodies"), 11, "some_bodies");
  EXPECT_FALSE(along({{0, 0, 0}, {10, 0, 0}}, {}, open));
  std::string ignored = kFenced;
  ignored.insert(ignored.rfind("</robot>"), "<lamina_ignore link1=\"nozzle\" link2=\"cell_bodies\"/>");
  EXPECT_FALSE(along({{0, 0, 0}, {10, 0, 0}}, {}, ignored));
}

}  // namespace
}  // namespace lamina
