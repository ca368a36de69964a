// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/creases.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/geometry/parts/parts.hpp"
#include "support/surfaces.hpp"

namespace lamina {
namespace {

using namespace test;

Creases creasesOf(const Mesh& mesh, double least_area = 0.0) {
  return findCreases(mesh, pairHalfEdges(mesh), least_area);
}

/// A disc of radius 5 with a wall around it, of 10 mm along the slope that rises by an angle.
Mesh cup(std::uint32_t around, double rise) {
  return disc(around, 15, [=](double share, double angle) {
    const double along = std::max(0.0, 15.0 * share - 5.0);
    const double r = std::min(15.0 * share, 5.0) + along * std::cos(rise);
    return Point3(r * std::cos(angle), r * std::sin(angle), along * std::sin(rise));
  });
}

TEST(Creases, DivideACupIntoItsFloorAndItsWall) {
  const Mesh mesh = cup(90, 1.0);
  const Creases creases = creasesOf(mesh);
  ASSERT_EQ(creases.parts, 2U);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    bool is_floor = true;
    for (const std::uint32_t v : mesh.triangles[t]) is_floor = is_floor && mesh.vertices[v].z() == 0.0;
    EXPECT_EQ(creases.part[t], is_floor ? 0U : 1U);
  }
  // A full turn less the angle that the wall takes when it is unrolled.
  EXPECT_NEAR(creases.curvature, 2.0 * M_PI * (1.0 - std::cos(1.0)), 0.01);
  EXPECT_NEAR(creases.inside, 0.0, 1e-9);
}

TEST(Creases, LeaveWhatBendsLittleWhole) {
  EXPECT_EQ(creasesOf(cup(90, 0.5)).parts, 1U);
  EXPECT_EQ(creasesOf(makePart("sphere")).parts, 1U);
}

TEST(Creases, LeaveWhatUnrollsTogetherWhole) {
  // A tube of eight facets with a floor: two halves of the tube.
  EXPECT_EQ(creasesOf(cup(8, 0.5 * M_PI)).parts, 3U);
}

TEST(Creases, DivideAtAllOfThemWhatUnrollsAsAWhole) {
  const Mesh folded = patch(8, 8, [](double u, double v) { return Point3(u, v, std::abs(u - 0.5)); });
  EXPECT_EQ(creasesOf(folded).parts, 2U);
}

TEST(Creases, CountSmallPartsToTheirNeighbours) {
  // The floor has 25 pi mm2.
  const Mesh mesh = cup(90, 1.0);
  EXPECT_EQ(creasesOf(mesh, 70.0).parts, 2U);
  EXPECT_EQ(creasesOf(mesh, 80.0).parts, 1U);
}

TEST(Creases, OfASolidHoldAllItsCurvature) {
  const Creases creases = creasesOf(makePart("tetradecahedron"));
  EXPECT_GE(creases.parts, 2U);
  EXPECT_LE(creases.parts, 14U);
  EXPECT_NEAR(creases.curvature, 4.0 * M_PI, 1e-6);
  EXPECT_NEAR(creases.inside, 0.0, 1e-9);
}

TEST(Creases, OfAnEmptySurfaceAreNone) { EXPECT_EQ(creasesOf({}).parts, 0U); }

}  // namespace
}  // namespace lamina
