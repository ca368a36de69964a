// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/lightning/branches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;
using Branches = std::vector<std::vector<Polyline>>;

constexpr double kBranchLayer = 0.2;  // mm, of all layers; at 45 deg also the reach
constexpr double kOnALine = 1e-3;

double distanceToSegment(const Point2& place, const Point2& a, const Point2& b) {
  const Point2 along = b - a;
  const double squared = along.squaredNorm();
  const double at = squared > 0.0 ? std::clamp((place - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (place - a - at * along).norm();
}

double distanceToBranches(const std::vector<Polyline>& branches, const Point2& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Polyline& branch : branches)
    for (std::size_t i = 1; i < branch.size(); ++i)
      nearest = std::min(nearest, distanceToSegment(place, branch[i - 1], branch[i]));
  return nearest;
}

/// Points along branches, a tenth of a millimetre apart.
std::vector<Point2> pointsAlong(const std::vector<Polyline>& branches) {
  std::vector<Point2> points;
  for (const Polyline& branch : branches)
    for (std::size_t i = 1; i < branch.size(); ++i) {
      const int pieces = 1 + static_cast<int>((branch[i] - branch[i - 1]).norm() / 0.1);
      for (int k = 0; k <= pieces; ++k)
        points.emplace_back(branch[i - 1] + (branch[i] - branch[i - 1]) * k / pieces);
    }
  return points;
}

double branchLength(const std::vector<Polyline>& branches) {
  double sum = 0.0;
  for (const Polyline& branch : branches) sum += length(branch);
  return sum;
}

std::vector<BranchLayer> tower(const Regions& inside, std::size_t count) {
  std::vector<BranchLayer> layers(count, BranchLayer{inside, {}, kBranchLayer});
  layers.back().roof = inside;
  return layers;
}

Branches grown(const std::vector<BranchLayer>& layers, double spacing_mm, double overrun_mm = 0.0) {
  NoProgress nobody;
  return branchesUnderRoofs(layers, {spacing_mm, overrun_mm}, nobody);
}

/// Every bead of a branch lies on one of the layer below or a wall, or stands out by the reach.
void expectHeld(const std::vector<BranchLayer>& layers, const Branches& branches) {
  for (std::size_t i = 1; i < layers.size(); ++i) {
    const std::vector<Polygon> walls = outlines(layers[i - 1].inside);
    for (const Point2& point : pointsAlong(branches[i])) {
      if (!contains(outlines(layers[i].inside), point)) continue;  // not deposited
      if (!contains(walls, point)) continue;                       // over the wall of the layer below
      const double distance =
          std::min(distanceToBranches(branches[i - 1], point), test::distanceToOutline(walls, point));
      ASSERT_LE(distance, layers[i - 1].reach_mm + kOnALine) << "layer " << i << " at " << point.transpose();
    }
  }
}

TEST(LightningBranches, HoldEveryPlaceOfARoof) {
  const Regions inside = {{rectangle(0, 0, 40, 40), {}}};
  const std::vector<Polyline> top = grown(tower(inside, 1), 3.0).front();
  for (double x = 0.25; x < 40.0; x += 0.5)
    for (double y = 0.25; y < 40.0; y += 0.5) {
      const Point2 place(x, y);
      const double wall = std::min({x, y, 40.0 - x, 40.0 - y});
      // Half a spacing, and half a diagonal of the grid of places that are looked at.
      ASSERT_LE(std::min(wall, distanceToBranches(top, place)), 1.5 + 0.35 * 3.0 / std::sqrt(2.0) + 0.1)
          << place.transpose();
    }
}

TEST(LightningBranches, StandOnTheLayerBelowAndVanishTowardsTheWalls) {
  const Regions inside = {{rectangle(0, 0, 40, 40), {}}};
  const std::vector<BranchLayer> layers = tower(inside, 220);
  const Branches branches = grown(layers, 3.0);
  expectHeld(layers, branches);
  for (std::size_t i = 1; i < layers.size(); ++i)
    EXPECT_LE(branchLength(branches[i - 1]), branchLength(branches[i]) + kOnALine) << i;
  // No branch is farther from the walls than half the width: 20 mm, or 100 layers, of which branches that go
  // askew need up to twice as many.
  EXPECT_TRUE(branches.front().empty()) << branchLength(branches.front());
  EXPECT_GT(branchLength(branches.back()), 100.0);
}

TEST(LightningBranches, FollowWallsThatMoveAway) {
  std::vector<BranchLayer> layers;
  for (std::size_t i = 0; i < 60; ++i) {
    const double half = 12.0 - 0.1 * static_cast<double>(i);  // walls lean by 27 deg from the vertical
    layers.push_back({{{rectangle(-half, -half, half, half), {}}}, {}, kBranchLayer});
  }
  layers.back().roof = layers.back().inside;
  const Branches branches = grown(layers, 2.0);
  ASSERT_GT(branchLength(branches.back()), 5.0);
  expectHeld(layers, branches);
}

TEST(LightningBranches, OfRandomPartsStandOnWhatIsBelow) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    std::vector<BranchLayer> layers(20);
    const Regions base = unite(
        {test::star(random, {0, 0}, 6.0, 14.0, 16), test::reversed(test::star(random, {0, 0}, 1.0, 3.0, 8))});
    for (std::size_t i = 0; i < layers.size(); ++i) {
      layers[i].inside = offset(base, random.uniform(-0.1, 0.1));
      layers[i].reach_mm = random.uniform(0.1, 0.4);
      if (random.below(4) == 0)
        layers[i].roof = intersection(layers[i].inside, {{test::star(random, {5, 3}, 2.0, 9.0, 9), {}}});
    }
    const Branches branches = grown(layers, random.uniform(1.5, 4.0));
    expectHeld(layers, branches);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(LightningBranches, RunIntoTheWallsTheyGrowFrom) {
  const Regions inside = {{rectangle(0, 0, 20, 20), {}}};
  const std::vector<Polyline> plain = grown(tower(inside, 1), 2.5).front();
  const std::vector<Polyline> longer = grown(tower(inside, 1), 2.5, 0.4).front();
  ASSERT_EQ(plain.size(), longer.size());
  std::size_t roots = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (test::distanceToOutline(outlines(inside), plain[i].back()) > kOnALine) {
      EXPECT_EQ(plain[i], longer[i]) << "joins another branch";
      continue;
    }
    ++roots;
    EXPECT_NEAR(length(longer[i]) - length(plain[i]), 0.4, 1e-9);
    EXPECT_FALSE(contains(outlines(inside), longer[i].back()));
  }
  EXPECT_GT(roots, 4U);
}

TEST(LightningBranches, AreNoneWithoutARoof) {
  const Regions inside = {{rectangle(0, 0, 20, 20), {}}};
  std::vector<BranchLayer> layers = tower(inside, 5);
  layers.back().roof.clear();
  const auto branches = grown(layers, 2.0);
  ASSERT_EQ(branches.size(), 5U);
  for (const std::vector<Polyline>& each : branches) EXPECT_TRUE(each.empty());
}

TEST(LightningBranches, CanBeCancelled) {
  class Cancelled final : public Progress {
   public:
    void report(const std::string&, double) override {}
    bool isCancelled() const override { return true; }
  } progress;
  EXPECT_THROW(branchesUnderRoofs(tower({{rectangle(0, 0, 9, 9), {}}}, 3), {2.0, 0.0}, progress),
               lamina::Cancelled);
}

}  // namespace
}  // namespace lamina
