// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/bead_solid.hpp"

#include <gtest/gtest.h>

#include "lamina/geometry/mesh/mesh_report.hpp"

namespace lamina {
namespace {

TEST(BeadSolid, IsAClosedPrismBelowTheMotionSeenFromOutside) {
  const Mesh mesh = beadSolid({{0, 0, 2}, {30, 40, 2}, {0, 0, -1}, {0.5, 0.2}});
  NoProgress nobody;
  EXPECT_TRUE(reportMesh(mesh, nobody).is_closed);
  // Positive with faces turned outwards: 50 mm long.
  EXPECT_NEAR(volume(mesh), 50.0 * 0.5 * 0.2, 1e-9);
  const Box3 box = boundingBox(mesh);
  EXPECT_NEAR(box.low.z(), 1.8, 1e-12);
  EXPECT_NEAR(box.high.z(), 2.0, 1e-12);
  EXPECT_NEAR(box.low.x(), -0.25 * 0.8, 1e-12);
}

TEST(BeadSolid, IsNothingWhereNothingIsLaidAcrossTheToolAxis) {
  EXPECT_TRUE(beadSolid({{1, 2, 3}, {1, 2, 3}, {0, 0, -1}, {0.5, 0.2}}).triangles.empty());
  EXPECT_TRUE(beadSolid({{1, 2, 3}, {1, 2, 9}, {0, 0, -1}, {0.5, 0.2}}).triangles.empty());
}

}  // namespace
}  // namespace lamina
