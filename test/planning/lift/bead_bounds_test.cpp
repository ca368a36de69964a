// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/lift/bead_bounds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdint>
#include <numeric>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kSection = 0.08;  // mm², of a usual bead

MotionLoad motion(double length_mm, double usual_loads) {
  const double usual = kSection * length_mm;
  return {usual_loads * usual, usual, length_mm};
}

LoadLimits limits() { return {2.0, 0.4, false}; }

TEST(BeadBounds, LeaveWhatFitsExactlyAsItIs) {
  const std::vector<MotionLoad> motions = {motion(3.0, 1.0), motion(0.01, 2.0), motion(1.0, 0.0)};
  const BoundedLoads bounded = boundLoads(motions, limits());
  for (std::size_t i = 0; i < motions.size(); ++i) EXPECT_EQ(bounded.mm3[i], motions[i].mm3) << i;
  EXPECT_EQ(bounded.left_out_mm3, 0.0);
}

TEST(BeadBounds, SpreadALoadOverTheNeighboursOfAMotionThatIsTooShort) {
  // 0.2 mm of bead on 0.01 mm: with 0.4 mm on either side all of it has room.
  const std::vector<MotionLoad> motions = {motion(5.0, 1.0), motion(0.3, 1.0), motion(0.01, 20.0),
                                           motion(0.3, 1.0), motion(5.0, 1.0)};
  const BoundedLoads bounded = boundLoads(motions, limits());
  EXPECT_EQ(bounded.left_out_mm3, 0.0);
  EXPECT_EQ(bounded.mm3.front(), motions.front().mm3);
  EXPECT_EQ(bounded.mm3.back(), motions.back().mm3);
  EXPECT_NEAR(bounded.mm3[2] / motions[2].usual_mm3, 0.5 / 0.31, 1e-12);
  EXPECT_NEAR(bounded.mm3[3] / motions[3].usual_mm3, 0.5 / 0.31, 1e-12);
}

TEST(BeadBounds, LeaveOutWhatHasNoRoomWithinTheReach) {
  const std::vector<MotionLoad> motions = {motion(1.0, 1.0), motion(0.1, 100.0), motion(0.3, 1.0),
                                           motion(5.0, 1.0)};
  const BoundedLoads bounded = boundLoads(motions, limits());
  // Of 10.3 mm of bead, two beads on 0.4 mm are deposited.
  EXPECT_NEAR(bounded.left_out_mm3, (10.3 - 0.8) * kSection, 1e-12);
  EXPECT_EQ(bounded.mm3[0], motions[0].mm3);
  EXPECT_EQ(bounded.mm3[3], motions[3].mm3);
}

TEST(BeadBounds, UseNoMoreOfALongNeighbourThanIsWithinReach) {
  const std::vector<MotionLoad> motions = {motion(0.1, 10.0), motion(50.0, 1.0)};
  const BoundedLoads bounded = boundLoads(motions, limits());
  // 0.3 mm of the neighbour may be twice as full.
  EXPECT_NEAR(bounded.mm3[1], 50.3 * kSection, 1e-12);
  EXPECT_NEAR(bounded.left_out_mm3, (1.0 - 0.2 - 0.3) * kSection, 1e-12);
}

TEST(BeadBounds, LayNothingWhereThePlanLaysNothing) {
  const BoundedLoads bounded = boundLoads({{0.01, 0.0, 1e-6}, {0.0, 0.0, 1.0}}, limits());
  EXPECT_EQ(bounded.mm3[0], 0.0);
  EXPECT_EQ(bounded.mm3[1], 0.0);
  EXPECT_EQ(bounded.left_out_mm3, 0.01);
}

TEST(BeadBounds, ReachAcrossTheStartOfAClosedRunOnly) {
  const std::vector<MotionLoad> motions = {motion(0.01, 20.0), motion(0.05, 2.0), motion(0.3, 1.0)};
  LoadLimits closed = limits();
  closed.is_closed = true;
  EXPECT_EQ(boundLoads(motions, closed).left_out_mm3, 0.0);
  // The next holds as much as it may; only the one behind the start, or beyond that, has room.
  const BoundedLoads open = boundLoads({motions[0], motions[1]}, limits());
  EXPECT_GT(open.left_out_mm3, 0.0);
}

TEST(BeadBounds, KeepTheSumAndTheBound) {
  EXPECT_TRUE(rc::check([] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    LoadLimits any = limits();
    any.is_closed = random.below(2) == 0;
    std::vector<MotionLoad> motions;
    double sum = 0.0;
    for (std::uint64_t i = 1 + random.below(30); i > 0; --i) {
      const double length = std::pow(10.0, random.uniform(-7.0, 0.5));
      motions.push_back({random.uniform(0.0, 0.1), random.below(5) == 0 ? 0.0 : kSection * length, length});
      sum += motions.back().mm3;
    }
    const BoundedLoads bounded = boundLoads(motions, any);
    const double deposited = std::accumulate(bounded.mm3.begin(), bounded.mm3.end(), 0.0);
    RC_ASSERT(std::abs(deposited + bounded.left_out_mm3 - sum) <= 1e-12);
    for (std::size_t i = 0; i < motions.size(); ++i)
      RC_ASSERT(bounded.mm3[i] <= any.fullest * motions[i].usual_mm3 * (1.0 + 1e-8));
  }));
}

}  // namespace
}  // namespace lamina
