// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/overhang/bead_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kMargin = 0.3;  // mm

Point3 beadGridAnywhere(Random& random) {
  return {random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(0, 3)};
}

/// Distance in the plane of the layers, and the height of the middle line there.
struct Nearest {
  double distance = 0.0;
  double z = 0.0;
};

Nearest nearest(const DepositedBead& bead, const Point2& place) {
  const Point2 along = (bead.end - bead.start).head<2>();
  const double t = std::clamp((place - bead.start.head<2>()).dot(along) / along.squaredNorm(), 0.0, 1.0);
  const Point3 point = bead.start + t * (bead.end - bead.start);
  return {(point.head<2>() - place).norm(), point.z()};
}

TEST(BeadGrid, FindsEveryBeadWithinTheMarginBetweenTheHeights) {
  EXPECT_TRUE(rc::check("any beads, any place", [](std::uint64_t seed) {
    Random random(seed);
    std::vector<DepositedBead> beads(100);
    for (DepositedBead& bead : beads)
      bead = {beadGridAnywhere(random),
              beadGridAnywhere(random),
              {random.uniform(0.2, 1.0), random.uniform(0.1, 0.5)}};
    const BeadGrid grid(beads, kMargin);
    const Point2 place = beadGridAnywhere(random).head<2>();
    const double low = random.uniform(-1.0, 3.0);
    const double high = low + random.uniform(0.0, 1.0);
    std::set<std::size_t> found;
    grid.visitNear(place, low, high, [&](std::size_t bead) {
      found.insert(bead);
      return false;
    });
    for (std::size_t i = 0; i < beads.size(); ++i) {
      const Nearest at = nearest(beads[i], place);
      const bool must_be_found =
          at.distance <= 0.5 * beads[i].section.width_mm + kMargin && at.z >= low && at.z <= high;
      RC_ASSERT(!must_be_found || found.count(i) == 1U);
    }
  }));
}

TEST(BeadGrid, OfNoBeadsFindsNone) {
  const BeadGrid grid({}, kMargin);
  EXPECT_FALSE(grid.visitNear({0, 0}, -1.0, 1.0, [](std::size_t) { return true; }));
}

}  // namespace
}  // namespace lamina
