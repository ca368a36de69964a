// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/conformal/facing_surface.hpp"

#include <gtest/gtest.h>

#include "lamina/geometry/parts/parts.hpp"
#include "support/curved_parts.hpp"

namespace lamina {
namespace {

TEST(FacingSurface, OfTheOctagonSolidIsItsBaseAndFourSlopes) {
  const Mesh solid = test::octagonSolid();
  const auto lower = facingPatches(solid, Facing::Down, 0.001);
  const auto upper = facingPatches(solid, Facing::Up, 0.001);
  ASSERT_EQ(lower.size(), 1U);
  ASSERT_EQ(upper.size(), 1U);
  EXPECT_EQ(lower[0].size(), 10U);
  EXPECT_EQ(upper[0].size(), 10U);
  EXPECT_EQ(remainder(solid, lower[0], upper[0]).size(), 8U);
  const Mesh patch = patchOf(solid, lower[0]);
  EXPECT_EQ(patch.vertices.size(), 8U);
  EXPECT_NEAR(boundingBox(patch).high.z(), 10.0 / (2.0 + std::sqrt(2.0)), 1e-12);
}

TEST(FacingSurface, OfASphereAreItsTwoHalves) {
  const Mesh sphere = makePart("sphere", {{"radius_mm", "7"}, {"segments", "32"}});
  ASSERT_EQ(sphere.triangles.size(), 960U);
  const auto lower = facingPatches(sphere, Facing::Down, 0.001);
  const auto upper = facingPatches(sphere, Facing::Up, 0.001);
  ASSERT_EQ(lower.size(), 1U);
  ASSERT_EQ(upper.size(), 1U);
  EXPECT_EQ(lower[0].size(), 480U);
  EXPECT_EQ(upper[0].size(), 480U);
  EXPECT_TRUE(remainder(sphere, lower[0], upper[0]).empty());
}

TEST(FacingSurface, ThePatchWithTheLowestPlaceComesFirst) {
  Mesh two = makePart("sphere", {{"segments", "8"}});
  const std::size_t vertices = two.vertices.size();
  const std::size_t triangles = two.triangles.size();
  for (std::size_t i = 0; i < vertices; ++i)
    two.vertices.emplace_back(two.vertices[i] + Point3(50.0, 0.0, -3.0));
  for (std::size_t i = 0; i < triangles; ++i) {
    Triangle shifted = two.triangles[i];
    for (std::uint32_t& corner : shifted) corner += static_cast<std::uint32_t>(vertices);
    two.triangles.push_back(shifted);
  }
  const auto lower = facingPatches(two, Facing::Down, 0.001);
  ASSERT_EQ(lower.size(), 2U);
  EXPECT_GE(lower[0].front(), triangles);
  EXPECT_LT(facingPatches(two, Facing::Up, 0.001)[0].back(), triangles);
}

TEST(FacingSurface, UprightWallsAreTheWallsBesideAPatch) {
  const Mesh box = makePart("box");
  const auto lower = facingPatches(box, Facing::Down, 0.001);
  const ShellSource source = shellSourceOf(box, lower[0]);
  EXPECT_EQ(source.surface.vertices.size(), 4U);
  EXPECT_FALSE(source.walls.empty());
  for (const RimWall& wall : source.walls) {
    EXPECT_LT(wall.vertex, 4U);
    EXPECT_NEAR(wall.normal.z(), 0.0, 1e-12);
  }
}

TEST(FacingSurface, TurnedOverItFacesTheOtherWay) {
  const Mesh box = makePart("box");
  EXPECT_NEAR(volume(turnedOver(box)), -volume(box), 1e-9);
}

}  // namespace
}  // namespace lamina
