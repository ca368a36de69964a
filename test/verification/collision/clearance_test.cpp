// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/clearance.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kClose = 1e-4;  // mm: the precision of the collision of a cone with a box, and more

CartesianMachine upright() { return machineByName("cartesian_gantry"); }

/// A body that goes wherever the nozzle does.
/// @param above  middle of the body over the tip [mm, bed frame]
MachineBody bodyOf(const BodyShape& shape, const Eigen::Isometry3d& above) {
  MachineBody body;
  body.link = "nozzle";
  body.shape = shape;
  body.motion = Eigen::Matrix3d::Identity();
  body.bed_from_body_at_zero = Eigen::Translation3d(upright().bed_from_nozzle_at_zero.translation()) * above;
  return body;
}

/// A cone that stands on the tip.
MachineBody coneOf(double half_angle, double length_mm) {
  const Eigen::Isometry3d above =
      Eigen::Translation3d(0, 0, 0.5 * length_mm) * Eigen::AngleAxisd(M_PI, Point3::UnitX());
  return bodyOf(ConeShape{length_mm * std::tan(half_angle), length_mm}, above);
}

/// A block of twice that half width, its underside so far above the tip.
MachineBody blockOf(double half_width_mm, double above_mm) {
  const Point3 size(2 * half_width_mm, 2 * half_width_mm, 30.0);
  return bodyOf(BoxShape{size}, Eigen::Isometry3d(Eigen::Translation3d(0, 0, above_mm + 15.0)));
}

ClearanceReport checked(const Toolpath& toolpath, const MachineBody& body, double tolerance_mm = 0.0) {
  ClearanceSettings settings;
  settings.tolerance_mm = tolerance_mm;
  NoProgress nobody;
  const CartesianMachine machine = upright();
  return checkClearance({toolpath, Eigen::Isometry3d::Identity(), machine}, {body}, settings, nobody);
}

Path travel(const Point3& from, const Point3& to) {
  Path path = test::straightPath(from, to);
  path.role = PathRole::Travel;
  path.bead = Bead{};
  return path;
}

/// A wall of one bead, 1 mm wide, along y at that x, and a travel that comes down beside it to (0, 0, z).
Toolpath besideWall(double x, double wall_height, double z) {
  Path wall = test::straightPath({x, -40, wall_height}, {x, 40, wall_height});
  wall.bead = Bead{1.0, wall_height};
  const Path up = travel(wall.lastPoint(), {0, 40, 100});
  const Path over = travel(up.lastPoint(), {0, 0, 100});
  return {"wall", {{wall_height, wall_height, {wall, up, over, travel(over.lastPoint(), {0, 0, z})}}}};
}

TEST(Clearance, AConeMeetsAWallExactlyWhereItsFlankDoes) {
  // Half angle 45 deg: at the top of the wall, 10 mm, the cone over a tip at z is 10 - z wide. The wall's
  // near edge is 4.5 mm away, so that it clears down to z = 5.5.
  const MachineBody cone = coneOf(M_PI / 4, 30.0);
  EXPECT_EQ(checked(besideWall(5.0, 10.0, 5.5 + kClose), cone).colliding, 0U);
  const auto firsts = checked(besideWall(5.0, 10.0, 5.5 - kClose), cone).first_of_layers;
  ASSERT_EQ(firsts.size(), 1U);
  EXPECT_EQ(firsts[0].obstacle, Obstacle::Material);
  EXPECT_EQ(firsts[0].at.path, 3U);
  EXPECT_EQ(firsts[0].at.waypoint, 1U);
  EXPECT_EQ(firsts[0].deposited.path, 0U);
  EXPECT_EQ(firsts[0].link, "nozzle");
  EXPECT_TRUE(firsts[0].tip.isApprox(Point3(0, 0, 5.5 - kClose)));
}

TEST(Clearance, AConeOfAnyAngleMeetsAWallAtItsAnalyticLimit) {
  EXPECT_TRUE(rc::check("any half angle, wall and tolerance", [](std::uint64_t seed) {
    Random random(seed);
    const double half_angle = random.uniform(0.2, 1.1);
    const double wall_height = random.uniform(10.0, 30.0);
    const double tolerance = random.uniform(0.0, 0.2);
    const double gap = random.uniform(0.2, 0.8) * wall_height * std::tan(half_angle);
    const double limit = wall_height - tolerance - (gap + tolerance) / std::tan(half_angle);
    const MachineBody cone = coneOf(half_angle, 40.0);
    RC_ASSERT(checked(besideWall(gap + 0.5, wall_height, limit + 1e-3), cone, tolerance).colliding == 0U);
    RC_ASSERT(checked(besideWall(gap + 0.5, wall_height, limit - 1e-3), cone, tolerance).colliding > 0U);
  }));
}

TEST(Clearance, TheNozzleMayStandInWhatItIsJustLaying) {
  Toolpath toolpath = {"bead", {{1.0, 1.0, {test::straightPath({0, 0, 1.0}, {20, 0, 1.0})}}}};
  toolpath.layers[0].paths[0].bead = Bead{4.0, 1.0};
  const MachineBody deep = blockOf(1.0, -0.5);
  EXPECT_EQ(checked(toolpath, deep).colliding, 0U);
  toolpath.layers[0].paths.push_back(travel({20, 0, 1.0}, {10, 0, 1.0}));
  const auto firsts = checked(toolpath, deep).first_of_layers;
  ASSERT_EQ(firsts.size(), 1U) << "once it is deposited it is there";
  EXPECT_EQ(firsts[0].at.path, 1U);
}

TEST(Clearance, WhatIsDepositedLaterIsNotThereYet) {
  Toolpath toolpath = besideWall(5.0, 10.0, 5.0);
  std::reverse(toolpath.layers[0].paths.begin(), toolpath.layers[0].paths.end());
  for (Path& path : toolpath.layers[0].paths) std::reverse(path.points.begin(), path.points.end());
  EXPECT_EQ(checked(toolpath, coneOf(M_PI / 4, 30.0)).colliding, 0U);
}

TEST(Clearance, ABodyLowerThanTheTipMeetsTheBedWhereTheTipIsTooLow) {
  // It reaches 2 mm below the tip; the way down passes 2 mm at the third waypoint.
  Path path = travel({0, 0, 5}, {10, 0, 3});
  path.points.insert(path.points.end(), {{20, 0, 2.0 - 1e-6}, {30, 0, 4}});
  const ClearanceReport report = checked({"low", {{5, 1, {path}}}}, blockOf(1.0, -2.0));
  ASSERT_EQ(report.first_of_layers.size(), 1U);
  EXPECT_EQ(report.first_of_layers[0].obstacle, Obstacle::Bed);
  EXPECT_EQ(report.first_of_layers[0].at.waypoint, 2U);
  EXPECT_EQ(report.colliding, 1U);
  EXPECT_EQ(report.waypoints, 4U);
  EXPECT_EQ(checked({"low", {{5, 1, {path}}}}, blockOf(1.0, -2.0), 0.01).colliding, 0U)
      << "within the tolerance";
}

TEST(Clearance, PlacesBetweenWaypointsAreLookedAt) {
  Toolpath toolpath = besideWall(5.0, 10.0, 20.0);
  Path& low = toolpath.layers[0].paths.back();
  low = travel({0, 0, 100}, {-30, 0, 5});
  toolpath.layers[0].paths.push_back(travel({-30, 0, 5}, {40, 0, 5}));
  const ClearanceReport report = checked(toolpath, coneOf(0.3, 30.0));
  ASSERT_EQ(report.first_of_layers.size(), 1U) << "it goes through the wall";
  EXPECT_EQ(report.first_of_layers[0].at.path, 4U);
  EXPECT_EQ(report.colliding, 1U);
  EXPECT_NEAR(report.first_of_layers[0].tip.x(), 3.0, 2.0);
}

/// Lines along x in a layer inclined by 45 deg that rises towards +y, from its top down; the nozzle is
/// upright.
Toolpath downhill(int lines, double pitch_mm) {
  const Eigen::Quaterniond part_from_layers(Eigen::AngleAxisd(M_PI / 4, Point3::UnitX()));
  ToolpathLayer layer{0.2, 0.2, {}};
  for (int i = 0; i < lines; ++i) {
    const double y = (lines - i) * pitch_mm;
    const Path line = test::straightPath({0, y, 0.2}, {10, y, 0.2});
    if (i > 0) layer.paths.push_back(travel(layer.paths.back().lastPoint(), line.firstPoint()));
    layer.paths.push_back(line);
  }
  return withNozzle(turned({"hill", {layer}}, part_from_layers), nozzleDown());
}

TEST(Clearance, ANozzleHeldDownRunsIntoAnInclinedLayerAtTheComputedWaypoint) {
  // A bead's highest edge is 0.2 mm uphill of its middle: 0.2 / sqrt 2 higher. The first line is that high
  // over line j: (0.4 j + 0.2) / sqrt 2, and as far behind it, which the block overhangs. 4 mm are passed at
  // j = 13.64: on the way to line 14, which is travel 27.
  const Toolpath hill = downhill(30, 0.4);
  Eigen::Isometry3d high = Eigen::Isometry3d(Eigen::Translation3d(50, 50, 10));
  ClearanceSettings settings;
  settings.tolerance_mm = 0.0;
  NoProgress nobody;
  const CartesianMachine machine = upright();
  const auto report = checkClearance({hill, high, machine}, {blockOf(10.0, 4.0)}, settings, nobody);
  ASSERT_EQ(report.first_of_layers.size(), 1U);
  EXPECT_EQ(report.first_of_layers[0].at.path, 27U);
  EXPECT_EQ(report.first_of_layers[0].at.waypoint, 1U);
  EXPECT_EQ(report.first_of_layers[0].deposited.path, 0U);
  // From there on everything collides: 16 lines of two waypoints, and 16 travels, the first of them with its
  // end.
  EXPECT_EQ(report.colliding, 16U * 2U + 15U * 2U + 1U);
}

TEST(Clearance, AMachineWithoutCollisionGeometryIsRefused) {
  const CartesianMachine machine = upright();
  const Toolpath toolpath = test::twoLayers();
  const std::vector<MachineBody> none;
  NoProgress nobody;
  EXPECT_THROW(checkClearance({toolpath, Eigen::Isometry3d::Identity(), machine}, none, {}, nobody),
               InvalidConfig);
}

}  // namespace
}  // namespace lamina
