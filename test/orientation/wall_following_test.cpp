// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/wall_following.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/lofted_solid.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kMaxLean = 60.0;
constexpr int kAround = 720;

/// An outer wall along the surface of a solid about the z axis, counter-clockwise from above.
Path ringAt(double radius, double z) {
  Path ring;
  ring.role = PathRole::OuterWall;
  ring.is_closed = true;
  for (int j = 0; j < kAround; ++j) {
    const double phi = 2.0 * M_PI * j / kAround;
    ring.points.emplace_back(radius * std::cos(phi), radius * std::sin(phi), z);
  }
  return ring;
}

Path reversedPath(Path path) {
  std::reverse(path.points.begin(), path.points.end());
  return path;
}

/// For [Flores2018, figure 42]: the wall leans outwards by `theta_deg`.
void requireToolInTheWall(const Path& ring, const std::vector<Point3>& tool_axes, double theta_deg) {
  for (std::size_t i = 0; i < tool_axes.size(); ++i) {
    EXPECT_NEAR(std::acos(-tool_axes[i].z()) * 180.0 / M_PI, theta_deg, 0.05);
    EXPECT_LT(tool_axes[i].z(), 0.0);
    const Point3 along = (ring.points[(i + 1) % tool_axes.size()] - ring.points[i]).normalized();
    EXPECT_LE(std::abs(std::asin(tool_axes[i].dot(along))) * 180.0 / M_PI, 0.5);
    // Growing against the tool axis follows the wall outwards.
    EXPECT_LE(tool_axes[i].head<2>().dot(ring.points[i].head<2>()), 1e-9);
  }
}

TEST(WallFollowing, TheToolLiesInConesOfEveryLean) {
  for (const double theta_deg : {0.0, 7.12, 20.0, 30.0, 45.0}) {
    const double slope = std::tan(theta_deg * M_PI / 180.0);
    const Mesh cone =
        test::loftedSolid({0.0, 10.0, 20.0}, kAround, [&](double, double z) { return 20.0 + slope * z; });
    const WallNormals walls(cone, Point3::UnitZ(), kMaxLean);
    const Path ring = ringAt(20.0 + slope * 6.0, 6.0);
    for (const Path& path : {ring, reversedPath(ring)}) {
      const WallToolAxes following = wallFollowingToolAxes(path, walls);
      EXPECT_EQ(following.waypoints_without_wall, 0U);
      requireToolInTheWall(path, following.tool_axes, theta_deg);
    }
  }
}

TEST(WallFollowing, WhereThePathRunsIntoTheWallItsNeighbourIsTaken) {
  const Mesh box = test::boxBetween({0, 0, 0}, {20, 20, 5});
  const WallNormals walls(box, Point3::UnitZ(), kMaxLean);
  Path path;
  path.role = PathRole::OuterWall;
  path.points = {{0.1, 10, 2}, {2, 10, 2}, {10, 10, 2}};
  const WallToolAxes following = wallFollowingToolAxes(path, walls);
  EXPECT_GE(following.waypoints_without_wall, 2U);
  for (const Point3& tool_axis : following.tool_axes) EXPECT_EQ(tool_axis, Point3(0, 0, -1));
}

}  // namespace
}  // namespace lamina
