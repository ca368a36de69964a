// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/kept_lean.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/orientation/no_spin.hpp"
#include "lamina/orientation/orientation_limits.hpp"

namespace lamina {
namespace {

/// A bead of 21 waypoints, 1 mm apart, the tool axis leaning towards y by so much, a travel, and another
/// bead.
Toolpath leaning(double lean_deg) {
  const double lean = lean_deg * M_PI / 180.0;
  const Eigen::Quaterniond held = noSpinFrame(Point3(0.0, std::sin(lean), -std::cos(lean)), 0.0);
  Path bead;
  bead.role = PathRole::OuterWall;
  for (int i = 0; i <= 20; ++i) bead.points.emplace_back(i, 0, 1);
  bead.orientation = held;
  bead.bead = Bead{0.4, 0.2};
  bead.feed_mm_s = 30.0;
  Path travel = bead;
  travel.role = PathRole::Travel;
  travel.points = {{20, 0, 1}, {20, 0, 5}, {0, 5, 5}, {0, 5, 1}};
  Path other = bead;
  for (Point3& point : other.points) point.y() = 5.0;
  return {"leaning", {{1.0, 0.2, {bead, travel, other}}}};
}

double leanAt(const Toolpath& toolpath, std::size_t path, std::size_t waypoint) {
  return leanDeg(toolAxisOf(toolpath.layers[0].paths[path].orientation.at(waypoint)));
}

TEST(KeptLean, RaisesAPlaceAndWhatIsNearIt) {
  const Toolpath wanted = leaning(40.0);
  KeptLean lean(wanted, {});
  EXPECT_FALSE(lean.isChanged());
  lean.raiseAt({0, 0, 10});
  EXPECT_TRUE(lean.isChanged());
  const Toolpath raised = lean.toolpath();
  EXPECT_FALSE(lean.isChanged());
  // A quarter of 40 deg, within 2 mm; beyond, no more than 10 deg to the millimetre.
  for (const std::size_t i : {8U, 9U, 10U, 11U, 12U}) EXPECT_NEAR(leanAt(raised, 0, i), 30.0, 1e-9);
  for (const std::size_t i : {0U, 7U, 13U, 20U}) EXPECT_NEAR(leanAt(raised, 0, i), 40.0, 1e-9);
  EXPECT_NEAR(leanAt(raised, 2, 10), 40.0, 1e-9);
  EXPECT_NEAR(lean.least(), 0.75, 1e-12);
  EXPECT_EQ(lean.raised(), 5U);
}

TEST(KeptLean, EvensTheTurnAlongARun) {
  const Toolpath wanted = leaning(60.0);
  RaiseLimits limits;
  limits.reach_mm = 0.5;
  limits.step = 1.0;
  limits.most_deg_per_mm = 6.0;
  KeptLean lean(wanted, limits);
  lean.raiseAt({0, 0, 10});
  const Toolpath raised = lean.toolpath();
  for (int i = 0; i <= 20; ++i)
    EXPECT_NEAR(leanAt(raised, 0, static_cast<std::size_t>(i)), 6.0 * std::abs(i - 10), 1e-9) << i;
}

TEST(KeptLean, RaisesNoMoreThanItMay) {
  const Toolpath wanted = leaning(80.0);
  RaiseLimits limits;
  limits.most_deg = 20.0;
  limits.step = 0.5;
  KeptLean lean(wanted, limits);
  for (int i = 0; i < 4; ++i) lean.raiseAt({0, 0, 3});
  EXPECT_NEAR(leanAt(lean.toolpath(), 0, 3), 60.0, 1e-9);
  lean.raiseAt({0, 0, 3});
  EXPECT_FALSE(lean.isChanged());
}

TEST(KeptLean, ATravelIsRaisedAtBothItsEnds) {
  const Toolpath wanted = leaning(40.0);
  KeptLean lean(wanted, {});
  lean.raiseAt({0, 1, 2});
  const Toolpath raised = lean.toolpath();
  EXPECT_NEAR(leanAt(raised, 0, 20), 30.0, 1e-9);
  EXPECT_NEAR(leanAt(raised, 0, 10), 40.0, 1e-9);
  EXPECT_NEAR(leanAt(raised, 2, 0), 30.0, 1e-9);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(leanAt(raised, 1, i), 30.0, 1e-9);
}

TEST(KeptLean, AnUprightToolAxisStays) {
  const Toolpath wanted = leaning(0.0);
  KeptLean lean(wanted, {});
  lean.raiseAt({0, 0, 10});
  EXPECT_FALSE(lean.isChanged());
  EXPECT_EQ(lean.raised(), 0U);
}

/// A closed ring of 20 waypoints, 1 mm apart, that leans by 40 deg everywhere.
Toolpath leaningRing() {
  Toolpath toolpath = leaning(40.0);
  Path ring = toolpath.layers[0].paths[0];
  ring.is_closed = true;
  ring.points.clear();
  const double radius = 0.5 / std::sin(M_PI / 20.0);
  for (int i = 0; i < 20; ++i)
    ring.points.emplace_back(radius * std::cos(i * M_PI / 10.0), radius * std::sin(i * M_PI / 10.0), 1.0);
  toolpath.layers[0].paths = {ring};
  return toolpath;
}

TEST(KeptLean, ReachesOverTheStartOfAClosedRun) {
  const Toolpath wanted = leaningRing();
  RaiseLimits limits;
  limits.reach_mm = 2.5;
  limits.most_deg_per_mm = 20.0;
  for (const std::size_t at : {0U, 1U, 19U, 10U}) {
    KeptLean lean(wanted, limits);
    lean.raiseAt({0, 0, at});
    const Toolpath raised = lean.toolpath();
    EXPECT_EQ(lean.raised(), 5U) << at;
    for (std::size_t n = 0; n < 20; ++n)
      EXPECT_NEAR(leanAt(raised, 0, (at + n) % 20), n <= 2 || n >= 18 ? 30.0 : 40.0, 1e-9) << at << ", " << n;
  }
  limits.reach_mm = 100.0;
  KeptLean whole(wanted, limits);
  whole.raiseAt({0, 0, 3});
  whole.toolpath();
  EXPECT_EQ(whole.raised(), 20U);
}

}  // namespace
}  // namespace lamina
