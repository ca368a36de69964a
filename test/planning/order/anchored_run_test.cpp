// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/anchored_run.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

/// What lies left of x = 5 is carried.
bool isLeft(const Point2& point) { return point.x() < 5.0; }

FillPath run(std::vector<Point2> points, bool is_closed) {
  FillPath path;
  path.points = std::move(points);
  path.is_closed = is_closed;
  return path;
}

double width(const FillPath& path) {
  double sum = 0.0;
  for (std::size_t i = path.is_closed ? 0 : 1; i < path.points.size(); ++i) {
    const Point2& before = path.points[i == 0 ? path.points.size() - 1 : i - 1];
    sum += (path.points[i] - before).norm() * path.width_mm[i];
  }
  return sum;
}

TEST(AnchoredRun, OneThatBeginsOnMaterialStays) {
  const auto parts = anchored(run({{0, 0}, {10, 0}}, false), isLeft);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].points.front(), Point2(0, 0));
}

TEST(AnchoredRun, OneThatEndsOnMaterialIsTurnedRound) {
  const auto parts = anchored(run({{10, 0}, {7, 0}, {0, 0}}, false), isLeft);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].points, (Polyline{{0, 0}, {7, 0}, {10, 0}}));
}

TEST(AnchoredRun, OneWithBothEndsInTheAirIsPartedWhereItIsCarried) {
  const auto parts = anchored(run({{10, 0}, {1, 0}, {1, 4}, {10, 4}}, false), isLeft);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].points, (Polyline{{1, 0}, {10, 0}}));
  EXPECT_EQ(parts[1].points, (Polyline{{1, 0}, {1, 4}, {10, 4}}));
}

TEST(AnchoredRun, ALoopStartsAtItsLongestCarriedStretch) {
  const auto parts = anchored(run({{10, 0}, {4, 0}, {8, 1}, {1, 1}, {1, 9}, {10, 9}}, true), isLeft);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(parts[0].is_closed);
  EXPECT_EQ(parts[0].points, (Polyline{{1, 1}, {1, 9}, {10, 9}, {10, 0}, {4, 0}, {8, 1}}));
}

TEST(AnchoredRun, OneThatNothingCarriesAndDropsStay) {
  const FillPath in_air = run({{10, 0}, {7, 0}}, false);
  EXPECT_EQ(anchored(in_air, isLeft)[0].points, in_air.points);
  FillPath drops = run({{10, 0}, {0, 0}}, false);
  drops.deposit = Deposit::Drops;
  EXPECT_EQ(anchored(drops, isLeft)[0].points, drops.points);
}

/// A path from one place to another in the plane.
Path pathBetween(PathRole role, const Point3& from, const Point3& to) {
  Path path;
  path.role = role;
  path.points = {from, to};
  path.bead = Bead{0.4, 0.2};
  return path;
}

TEST(AnchoredRun, OneThatNothingCarriesBeginsBesideABeadOfItsLayer) {
  const std::vector<Path> deposited = {
      pathBetween(PathRole::OuterWall, {0, 0, 1}, {0, 10, 1}),
      pathBetween(PathRole::Travel, {0, 10, 1}, {8, 0, 1}),
      pathBetween(PathRole::Support, {8, 0, 1}, {8, 10, 1}),
  };
  FillPath lip = run({{7.5, 5}, {2, 5}, {0.4, 6}}, false);
  lip.width_mm = {0.3, 0.4, 0.5};
  const FillPath from_wall = begunAtBeads(lip, deposited);
  EXPECT_EQ(from_wall.points, (Polyline{{0.4, 6}, {2, 5}, {7.5, 5}}));
  EXPECT_EQ(begunAtBeads(from_wall, deposited).points, from_wall.points) << "it does so already";
  EXPECT_EQ(begunAtBeads(lip, {}).points, lip.points) << "without beads";
  EXPECT_NEAR(width(from_wall), width(lip), 1e-9) << "with its widths";
  lip.is_closed = true;
  EXPECT_EQ(begunAtBeads(lip, deposited).points, lip.points);
}

TEST(AnchoredRun, LaysTheSameMaterialFromACarriedStart) {
  EXPECT_TRUE(rc::check("material and start", [](std::uint64_t seed) {
    Random random(seed);
    FillPath path = run({}, random.uniform(0.0, 1.0) < 0.5);
    const int count = 3 + static_cast<int>(random.uniform(0.0, 6.0));
    for (int i = 0; i < count; ++i) {
      path.points.emplace_back(random.uniform(0.0, 10.0), random.uniform(0.0, 10.0));
      path.width_mm.push_back(random.uniform(0.2, 0.6));
    }
    double deposited = 0.0;
    const auto parts = anchored(path, isLeft);
    for (const FillPath& part : parts) {
      deposited += width(part);
      RC_ASSERT(part.points.size() >= 2U);
      const bool is_carried_anywhere = std::any_of(path.points.begin(), path.points.end(), isLeft);
      RC_ASSERT(!is_carried_anywhere || isLeft(part.points.front()));
    }
    RC_ASSERT(std::abs(deposited - width(path)) < 1e-9);
  }));
}

}  // namespace
}  // namespace lamina
