// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/plate/laying.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/plate/plate.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

/// A stem of 10 x 40 x 20 mm under a slab of 40 x 40 x 5 mm.
Mesh tee() {
  return joined(test::boxBetween({-5, -20, 0}, {5, 20, 20}), test::boxBetween({-20, -20, 20}, {20, 20, 25}));
}

TEST(Laying, TurnsAFunnelOver) {
  // Its wall leans by 63 deg.
  const Mesh part =
      makePart("cone", {{"radius_mm", "5"}, {"top_radius_mm", "15"}, {"height_mm", "5"}, {"segments", "64"}});
  const Laying best = layings(part, {}).front();
  EXPECT_NEAR(best.overhang_mm2, 0.0, 1e-9);
  EXPECT_NEAR(best.height_mm, 5.0, 1e-9);
  EXPECT_NEAR(best.face_mm2, 32.0 * 225.0 * std::sin(2.0 * M_PI / 64.0), 1e-6);
  EXPECT_NEAR(std::abs(best.turn_deg.x()), 180.0, 1e-9);
}

TEST(Laying, ReportsWhatHangs) {
  bool stands = false;
  for (const Laying& laying : layings(tee(), {})) {
    if (!laying.turn_deg.isZero()) continue;
    stands = true;
    EXPECT_NEAR(laying.overhang_mm2, 1600.0, 1e-9);  // the slab, which is a body of its own
    EXPECT_NEAR(laying.cost(), 1602.5, 1e-9);
  }
  EXPECT_TRUE(stands);
  // A box hangs nowhere: the lowest comes first.
  const std::vector<Laying> found = layings(test::boxBetween({0, 0, 0}, {10, 20, 30}), {});
  ASSERT_EQ(found.size(), 6U);
  EXPECT_NEAR(found[0].height_mm, 10.0, 1e-9);
  EXPECT_NEAR(found[5].cost(), 3.0, 1e-9);
}

TEST(Laying, TurnsEachFaceDown) {
  const Mesh part = makePart("tetradecahedron");
  const std::vector<Laying> found = layings(part, {});
  ASSERT_FALSE(found.empty());
  for (const Laying& laying : found) {
    const Mesh placed = transformed(part, standing(part, rotationOfDegrees(laying.turn_deg), 1.0));
    double on_bed_mm2 = 0.0;
    for (const Triangle& t : placed.triangles) {
      const Point3 doubled = (placed.vertices[t[1]] - placed.vertices[t[0]])
                                 .cross(placed.vertices[t[2]] - placed.vertices[t[0]]);
      if (std::max({placed.vertices[t[0]].z(), placed.vertices[t[1]].z(), placed.vertices[t[2]].z()}) < 1e-6)
        on_bed_mm2 += 0.5 * doubled.norm();
    }
    EXPECT_NEAR(on_bed_mm2, laying.face_mm2, 1e-6 * laying.face_mm2);
  }
}

TEST(Laying, RefusesWhatIsFlat) {
  const Mesh flat = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_THROW(layings(flat, {}), InvalidMesh);
}

}  // namespace
}  // namespace lamina
