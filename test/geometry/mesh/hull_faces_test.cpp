// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/hull_faces.hpp"

#include <gtest/gtest.h>

#include "lamina/geometry/parts/parts.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

TEST(HullFaces, OfABoxAreItsSides) {
  const std::vector<HullFace> faces = hullFaces(test::boxBetween({0, 0, 0}, {10, 20, 30}).vertices);
  ASSERT_EQ(faces.size(), 6U);
  EXPECT_NEAR(faces[0].area_mm2, 600.0, 1e-9);
  EXPECT_NEAR(faces[5].area_mm2, 200.0, 1e-9);
}

TEST(HullFaces, EncloseAllPoints) {
  const Mesh sphere = makePart("sphere");
  double sum_mm2 = 0.0;
  for (const HullFace& face : hullFaces(sphere.vertices)) sum_mm2 += face.area_mm2;
  EXPECT_NEAR(sum_mm2 / surfaceArea(sphere), 1.0, 1e-6);  // convex: its own hull
}

TEST(HullFaces, AreNoneOfFlatPoints) {
  EXPECT_TRUE(hullFaces({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}).empty());
}

}  // namespace
}  // namespace lamina
