// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/run_path.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kRunBead = 0.4;  // mm

/// Plan width times length of all motions [mm²].
double areaOfMotions(const FillPath& run) {
  double sum = 0.0;
  for (std::size_t i = 1; i < run.points.size(); ++i)
    sum += run.width_mm[i] * (run.points[i] - run.points[i - 1]).norm();
  return sum;
}

TEST(RunPath, GoesStraightOverShortMotionsAside) {
  // Three motions of 0.1 mm, 0.01 mm off the line, between lines of 3 mm.
  const FillPath run{{{0, 0}, {3, 0}, {3.1, 0.01}, {3.2, -0.01}, {3.3, 0}, {3.3, 3}},
                     false,
                     PathRole::Skin,
                     Deposit::Bead,
                     {0.3, 0.3, 0.1, 0.4, 0.2, 0.36}};
  const FillPath merged = withoutShortMotions(run, kRunBead);
  EXPECT_EQ(merged.points, (Polyline{{0, 0}, {3, 0}, {3.3, 0}, {3.3, 3}}));
  EXPECT_NEAR(areaOfMotions(merged), areaOfMotions(run), 1e-12);
  EXPECT_EQ(merged.width_mm[1], 0.3);
  EXPECT_EQ(merged.width_mm[3], 0.36);
}

TEST(RunPath, KeepsCornersAndLongMotionsOfUnequalWidth) {
  const FillPath run{{{0, 0}, {0.1, 0.05}, {0.2, 0}, {0.2, 1}, {0.2, 2}},
                     false,
                     PathRole::Skin,
                     Deposit::Bead,
                     {0.3, 0.3, 0.3, 0.2, 0.3}};
  EXPECT_EQ(withoutShortMotions(run, kRunBead).points, run.points);
  FillPath gap = run;
  gap.points = {{0, 0}, {0.1, 0}, {0.2, 0}};
  gap.width_mm = {0.3, 0.0, 0.3};
  EXPECT_EQ(withoutShortMotions(gap, kRunBead).points, gap.points) << "nothing is deposited in between";
}

TEST(RunPath, LeavesRunsOfOneWidthAndLoops) {
  FillPath run{{{0, 0}, {0.1, 0}, {0.2, 0}}, false, PathRole::Skin, Deposit::Bead, {}};
  EXPECT_EQ(withoutShortMotions(run, kRunBead).points.size(), 3U);
  run.width_mm = {0.3, 0.3, 0.3};
  run.is_closed = true;
  EXPECT_EQ(withoutShortMotions(run, kRunBead).points.size(), 3U);
}

TEST(RunPath, LeavesOutDotsInsideThePart) {
  const auto line = [](PathRole role, double length_mm) {
    return FillPath{{{0, 0}, {0.5 * length_mm, 0}, {length_mm, 0}}, false, role, Deposit::Bead, {}};
  };
  const auto stays = [&](const FillPath& run) { return withoutDots({run}, kRunBead).size() == 1; };
  EXPECT_FALSE(stays(line(PathRole::Infill, 0.79)));
  EXPECT_TRUE(stays(line(PathRole::Infill, 0.81)));
  for (const PathRole role : {PathRole::InnerWall, PathRole::GapFill, PathRole::Skin}) {
    EXPECT_FALSE(stays(line(role, 0.39))) << static_cast<int>(role);
    EXPECT_TRUE(stays(line(role, 0.41))) << static_cast<int>(role);
  }
  for (const PathRole role :
       {PathRole::OuterWall, PathRole::TopSkin, PathRole::BottomSkin, PathRole::Bridge, PathRole::Ironing})
    EXPECT_TRUE(stays(line(role, 0.01))) << static_cast<int>(role) << " is seen";
}

TEST(RunPath, LeavesOutNoDropsAndNoLoopsAsLongAsABead) {
  FillPath run{{{0, 0}, {0.15, 0}, {0, 0.1}}, false, PathRole::Skin, Deposit::Bead, {}};
  EXPECT_TRUE(withoutDots({run}, kRunBead).empty()) << "0.15 mm and 0.18 mm";
  run.is_closed = true;
  EXPECT_EQ(withoutDots({run}, kRunBead).size(), 1U) << "0.1 mm more";
  run = {{{0, 0}}, false, PathRole::Infill, Deposit::Drops, {}};
  EXPECT_EQ(withoutDots({run}, kRunBead).size(), 1U);
}

TEST(RunPath, StaysBesideTheRunWithItsVolume) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    FillPath run{{{0, 0}}, false, PathRole::Skin, Deposit::Bead, {0.3}};
    for (std::size_t count = 2 + random.below(60); count > 0; --count) {
      const double reach = random.below(4) == 0 ? 2.0 : 0.08;
      run.points.push_back(run.points.back() +
                           Point2(random.uniform(-reach, reach), random.uniform(-reach, reach)));
      run.width_mm.push_back(random.uniform(0.1, 0.5));
    }
    const FillPath merged = withoutShortMotions(run, kRunBead);
    RC_ASSERT(merged.points.size() == merged.width_mm.size());
    RC_ASSERT(merged.points.front() == run.points.front());
    RC_ASSERT(merged.points.back() == run.points.back());
    RC_ASSERT(std::abs(areaOfMotions(merged) - areaOfMotions(run)) < 1e-9);
    for (const Point2& point : run.points) {
      double nearest = 1e9;
      for (std::size_t i = 1; i < merged.points.size(); ++i)
        nearest = std::min(nearest,
                           (nearestOnSegment(merged.points[i - 1], merged.points[i], point) - point).norm());
      RC_ASSERT(nearest < 0.05 * kRunBead + 1e-9);
    }
  }));
}

}  // namespace
}  // namespace lamina
