// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/ladder_search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// One rotary joint that winds and one that does not.
std::vector<JointRange> twoJoints() {
  return jointRanges(
      {{"winding", JointKind::Rotary, -4.0, 4.0, 2.0}, {"short", JointKind::Rotary, -2.0, 2.0, 1.0}});
}

Rung randomRung(Random& random, SampleKind kind, int samples, int branches, int rows = 1) {
  Rung rung;
  rung.rows = rows;
  rung.kind = kind;
  rung.samples = samples;
  rung.branches = branches;
  rung.joints = 2;
  for (std::size_t slot = 0; slot < rung.slot(samples, 0); ++slot) {
    rung.values.push_back(random.uniform(-M_PI, M_PI));
    rung.values.push_back(random.uniform(-2.0, 2.0));
    rung.penalty.push_back(random.below(4) == 0 ? kNever : random.uniform(0.0, 1.0));
  }
  return rung;
}

StationMotion randomMotion(Random& random) {
  StationMotion motion;
  motion.duration_s = random.uniform(0.1, 1.0);
  motion.way = static_cast<StationWay>(random.below(3));
  return motion;
}

struct RungSlot {
  const Rung& rung;
  std::size_t slot;
};

/// What the header says of edges, written down once more.
double edgeCost(const RungSlot& first, const RungSlot& second, const StationMotion& motion,
                const JointPathSettings& settings) {
  const auto& [a, from] = first;
  const auto& [b, to] = second;
  if (!(a.penalty[from] < kNever) || !(b.penalty[to] < kNever)) return kNever;
  const double winding = std::remainder(b.at(to)[0] - a.at(from)[0], 2.0 * M_PI);
  const double straight = b.at(to)[1] - a.at(from)[1];
  const int per_row = b.samples / b.rows;
  const int apart = std::abs(sampleOf(a.idOf(from)) % per_row - sampleOf(b.idOf(to)) % per_row);
  const int around = std::min(apart, per_row - apart);
  const double yaw = 2.0 * M_PI * around / per_row;
  const int rows = std::abs(sampleOf(a.idOf(from)) / per_row - sampleOf(b.idOf(to)) / per_row);
  const bool is_next_row = std::min(rows, b.rows - rows) <= 1;
  const double turns = winding * winding / 4.0 + straight * straight + settings.yaw_weight * yaw * yaw;
  const double most = settings.max_turn_deg * M_PI / 180.0;
  const bool is_same = branchOf(a.idOf(from)) == branchOf(b.idOf(to));
  const bool is_small = std::abs(winding) <= most && std::abs(straight) <= most;
  const bool is_free = motion.way != StationWay::Deposition;
  const double cost = turns / motion.duration_s + b.penalty[to] * motion.duration_s;
  if (is_same && is_next_row && around <= settings.yaw_reach && (is_small || is_free)) return cost;
  return motion.way == StationWay::ClearTravel ? cost + settings.branch_change_cost : kNever;
}

struct SmallLadder {
  std::vector<Rung> rungs;
  std::vector<StationMotion> motions;
};

double wayCost(const SmallLadder& ladder, const std::vector<std::size_t>& slots,
               const JointPathSettings& settings) {
  double cost = ladder.rungs[0].penalty[slots[0]] * ladder.motions[0].duration_s;
  for (std::size_t i = 1; i < slots.size(); ++i)
    cost += edgeCost({ladder.rungs[i - 1], slots[i - 1]}, {ladder.rungs[i], slots[i]}, ladder.motions[i],
                     settings);
  return cost;
}

/// The least cost of all ways there are.
double bruteForce(const SmallLadder& ladder, const JointPathSettings& settings) {
  std::vector<std::size_t> slots(ladder.rungs.size(), 0);
  double least = kNever;
  for (;;) {
    least = std::min(least, wayCost(ladder, slots, settings));
    std::size_t i = 0;
    while (i < slots.size() && ++slots[i] == ladder.rungs[i].penalty.size()) slots[i++] = 0;
    if (i == slots.size()) return least;
  }
}

/// Ladders of random rungs of four samples a row, against all ways through them.
void expectTheCheapestWays(int rows) {
  int joined = 0;
  const std::size_t length = rows > 1 ? 3 : 5;  // all ways are tried
  EXPECT_TRUE(rc::check([&](std::uint32_t seed) {
    Random random(seed);
    JointPathSettings settings;
    settings.yaw_reach = 1;
    settings.max_turn_deg = 120.0;
    LadderSearch search(twoJoints(), settings, nullptr);
    SmallLadder ladder;
    bool is_whole = true;
    for (std::size_t i = 0; i < length; ++i) {
      ladder.rungs.push_back(randomRung(random, SampleKind::Yaw, 4 * rows, rows > 1 ? 1 : 2, rows));
      ladder.motions.push_back(randomMotion(random));
      const auto link = search.advance(ladder.rungs.back(), ladder.motions.back());
      is_whole &= link == LadderSearch::Link::Joined || (i == 0 && link == LadderSearch::Link::Start);
    }
    const double least = bruteForce(ladder, settings);
    RC_ASSERT(is_whole == std::isfinite(least));
    if (!is_whole) return;
    ++joined;
    std::vector<std::size_t> slots;
    const std::vector<NodeId> nodes = search.trace();
    for (std::size_t i = 0; i < nodes.size(); ++i) slots.push_back(ladder.rungs[i].slotOf(nodes[i]));
    RC_ASSERT(std::abs(wayCost(ladder, slots, settings) - least) < 1e-9);
  }));
  EXPECT_GT(joined, 10);
}

TEST(LadderSearch, FindsWhatTryingAllWaysFinds) { expectTheCheapestWays(1); }

TEST(LadderSearch, GoesFromRowToRow) { expectTheCheapestWays(5); }

/// A rung of one node.
Rung single(double winding, double straight) {
  Rung rung;
  rung.samples = 1;
  rung.branches = 1;
  rung.joints = 2;
  rung.values = {winding, straight};
  rung.penalty = {0.0};
  return rung;
}

TEST(LadderSearch, IsCutWhereAJointWouldLeapAndGoesOnAfterIt) {
  LadderSearch search(twoJoints(), {}, nullptr);
  EXPECT_EQ(search.advance(single(0.0, 0.0), {}), LadderSearch::Link::Start);
  EXPECT_EQ(search.advance(single(0.0, 1.9), {}), LadderSearch::Link::Cut);
  EXPECT_EQ(search.lastCut().joint, 1U);
  EXPECT_DOUBLE_EQ(search.lastCut().turn, 1.9);
  EXPECT_FALSE(search.lastCut().is_wound);
  EXPECT_EQ(search.advance(single(0.1, 1.8), {}), LadderSearch::Link::Joined);
  EXPECT_EQ(search.trace(), (std::vector<NodeId>{0, 0, 0}));
}

TEST(LadderSearch, GoesRoundTheShorterWayWithAJointThatWinds) {
  LadderSearch search(twoJoints(), {}, nullptr);
  search.advance(single(3.1, 0.0), {});
  EXPECT_EQ(search.advance(single(-3.1, 0.0), {}), LadderSearch::Link::Joined);
}

TEST(LadderSearch, LeavesOutARungWithoutNodes) {
  LadderSearch search(twoJoints(), {}, nullptr);
  search.advance(single(0.0, 0.0), {});
  EXPECT_EQ(search.advance(Rung(), {}), LadderSearch::Link::Empty);
  EXPECT_EQ(search.advance(single(0.0, 0.0), {}), LadderSearch::Link::Start);
  EXPECT_EQ(search.trace(), (std::vector<NodeId>{0, kNoNode, 0}));
}

}  // namespace
}  // namespace lamina
