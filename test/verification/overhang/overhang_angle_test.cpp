// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/overhang/overhang_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/geometry/shortest_rotation.hpp"

namespace lamina {
namespace {

constexpr double kOverhangAngleDegree = M_PI / 180.0;

/// A frustum on its small end, its wall leaning outwards by that angle.
Mesh funnel(double lean_deg) {
  const double top = 10.0 + 10.0 * std::tan(lean_deg * kOverhangAngleDegree);
  return makePart("cone", {{"radius_mm", "10"},
                           {"top_radius_mm", std::to_string(top)},
                           {"height_mm", "10"},
                           {"segments", "720"}});
}

/// One outer wall round the funnel in the middle of each of ten layers, the tool held along the wall or not.
Toolpath wallsOf(double lean_deg, double tool_lean_deg) {
  Toolpath toolpath;
  for (int k = 0; k < 10; ++k) {
    const double z = k + 1.0;
    const double radius = 10.0 + (k + 0.5) * std::tan(lean_deg * kOverhangAngleDegree);
    Path path;
    path.role = PathRole::OuterWall;
    path.is_closed = true;
    std::vector<Eigen::Quaterniond> tools;
    for (int i = 0; i < 360; ++i) {
      const Point3 out(std::cos(i * kOverhangAngleDegree), std::sin(i * kOverhangAngleDegree), 0.0);
      path.points.emplace_back(radius * out + z * Point3::UnitZ());
      const Point3 tool_axis = -std::cos(tool_lean_deg * kOverhangAngleDegree) * Point3::UnitZ() -
                               std::sin(tool_lean_deg * kOverhangAngleDegree) * out;
      tools.push_back(shortestRotation(Point3::UnitZ(), tool_axis));
    }
    path.orientation = AlongPath<Eigen::Quaterniond>(std::move(tools));
    path.bead = Bead{0.8, 1.0};
    toolpath.layers.push_back({z, 1.0, {path}});
  }
  return toolpath;
}

double wallArea(double lean_deg) {
  const double top = 10.0 + 10.0 * std::tan(lean_deg * kOverhangAngleDegree);
  return M_PI * (10.0 + top) * 10.0 / std::cos(lean_deg * kOverhangAngleDegree);
}

TEST(OverhangAngle, EachLayerIsPutOutByItsHeightTimesTheTangent) {
  for (const double lean_deg : {10.0, 30.0, 45.0}) {
    const OverhangAngle lean = overhangAngle(funnel(lean_deg), Point3::UnitZ(), {0.8, 1.0});
    EXPECT_NEAR(lean.greatest_rad / kOverhangAngleDegree, lean_deg, 0.01);
    EXPECT_NEAR(lean.overhang_mm, std::tan(lean_deg * kOverhangAngleDegree), 1e-3);
  }
}

TEST(OverhangAngle, WallsBeyondABeadAreCountedByTheirArea) {
  // 0.8 mm of a layer of 1 mm is a lean of 38.7 deg.
  EXPECT_EQ(overhangAngle(funnel(38.0), Point3::UnitZ(), {0.8, 1.0}).beyond_bead_mm2, 0.0);
  EXPECT_NEAR(overhangAngle(funnel(39.4), Point3::UnitZ(), {0.8, 1.0}).beyond_bead_mm2, wallArea(39.4), 0.5);
}

TEST(OverhangAngle, WhatStandsOnTheBedDoesNotLean) {
  const OverhangAngle lean = overhangAngle(makePart("box"), Point3::UnitZ(), {0.4, 0.2});
  EXPECT_EQ(lean.greatest_rad, 0.0);
  EXPECT_EQ(lean.overhang_mm, 0.0);
}

TEST(OverhangAngle, LevelUndersidesLeanByARightAngle) {
  // Grown along x, the side at the far end of -x is the bed and nothing else faces down; along (1, 0, 1) the
  // bottom does.
  EXPECT_EQ(overhangAngle(makePart("box"), Point3::UnitX(), {0.4, 0.2}).greatest_rad, 0.0);
  Mesh table = makePart("cone", {{"radius_mm", "2"}, {"top_radius_mm", "20"}, {"height_mm", "1e-6"}});
  for (Point3& vertex : table.vertices) vertex.z() += 5.0;
  const Mesh foot = makePart("cylinder", {{"radius_mm", "2"}, {"height_mm", "5"}});
  const auto first = static_cast<std::uint32_t>(table.vertices.size());
  table.vertices.insert(table.vertices.end(), foot.vertices.begin(), foot.vertices.end());
  for (const Triangle& corner : foot.triangles)
    table.triangles.push_back({first + corner[0], first + corner[1], first + corner[2]});
  EXPECT_NEAR(overhangAngle(table, Point3::UnitZ(), {0.4, 0.2}).greatest_rad, M_PI / 2.0, 1e-6);
}

TEST(OverhangAngle, AToolHeldAlongTheWallClearsTheOverhang) {
  const Mesh mesh = funnel(45.0);
  const OverhangAngle upright = overhangAngle(mesh, wallsOf(45.0, 0.0), 0.8);
  EXPECT_NEAR(upright.greatest_rad / kOverhangAngleDegree, 45.0, 0.05);
  EXPECT_GT(upright.beyond_bead_mm2, 0.8 * wallArea(45.0));
  const OverhangAngle along = overhangAngle(mesh, wallsOf(45.0, 45.0), 0.8);
  EXPECT_NEAR(along.greatest_rad / kOverhangAngleDegree, 0.0, 0.6);
  EXPECT_EQ(along.beyond_bead_mm2, 0.0);
}

TEST(OverhangAngle, AToolpathThatDepositsNothingIsRefused) {
  EXPECT_THROW(overhangAngle(makePart("box"), Toolpath{}, 0.4), InvalidInput);
}

}  // namespace
}  // namespace lamina
