// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/perimeters.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::reversed;

InfillRequest perimetersSolid(double pitch) {
  InfillRequest request;
  request.pitch_mm = request.spacing_mm = pitch;
  return request;
}

double radiusOf(const FillPath& run) { return run.points.front().norm(); }

/// For [Flores2018, section 6.2.1]: a circle of 20 mm, 1.5 mm between beads, 4 perimeters, the outermost on
/// the contour.
InfillRequest circleRequest(PerimeterOffset offset) {
  InfillRequest request = perimetersSolid(1.5);
  request.settings.perimeters.count = 4;
  request.settings.perimeters.first_inset = 0.0;
  request.settings.perimeters.offset = offset;
  return request;
}

const Regions& disc() {
  static const Regions regions = {{circle({0, 0}, 20.0, 720), {}}};
  return regions;
}

class PerimetersOfACircle : public testing::TestWithParam<PerimeterOffset> {};

TEST_P(PerimetersOfACircle, LieOneSpacingInsideTheOther) {
  const std::vector<FillPath> runs = perimeters(disc(), circleRequest(GetParam()));
  ASSERT_EQ(runs.size(), 4U);
  const double chord_error = 20.0 * (1.0 - std::cos(M_PI / 720));
  for (std::size_t k = 0; k < 4; ++k)
    for (const Point2& point : runs[k].points)
      EXPECT_NEAR(point.norm(), 20.0 - 1.5 * static_cast<double>(k), 1e-3 + chord_error);
}

TEST_P(PerimetersOfACircle, EndShortOfTheirStart) {
  for (const FillPath& run : perimeters(disc(), circleRequest(GetParam()))) {
    ASSERT_FALSE(run.is_closed);
    const double gap = (run.points.front() - run.points.back()).norm();
    EXPECT_GE(gap, 0.75);
    EXPECT_LE(gap, 1.20);
    EXPECT_NEAR(length(run.points), 2.0 * M_PI * radiusOf(run) - 0.65 * 1.5, 2e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Offsets, PerimetersOfACircle,
                         testing::Values(PerimeterOffset::Robust, PerimeterOffset::Normals),
                         [](const testing::TestParamInfo<PerimeterOffset>& offset) {
                           return offset.param == PerimeterOffset::Robust ? "Robust" : "Normals";
                         });

TEST(Perimeters, KeepToTheirBands) {
  InfillRequest request = perimetersSolid(1.0);
  request.settings.perimeters.count = 3;
  const Polygon square = rectangle(0, 0, 20, 20);
  double farthest = 0.0;
  for (const FillPath& run : perimeters({{square, {}}}, request))
    for (const Point2& point : run.points)
      farthest = std::max(farthest, test::distanceToOutline({square}, point));
  EXPECT_LE(farthest, 2.5 + 1e-4);
  EXPECT_GT(farthest, 1.5 + 1e-4) << "there is a third";
}

TEST(Perimeters, FollowTheHolesToo) {
  InfillRequest request = perimetersSolid(1.0);
  request.settings.perimeters.count = 2;
  const Regions loop = {{circle({0, 0}, 20, 180), {reversed(circle({0, 0}, 10, 180))}}};
  const std::vector<FillPath> runs = perimeters(loop, request);
  ASSERT_EQ(runs.size(), 4U);
  std::vector<double> radii;
  for (const FillPath& run : runs) radii.push_back(radiusOf(run));
  std::sort(radii.begin() + 0, radii.begin() + 2);
  std::sort(radii.begin() + 2, radii.end());
  EXPECT_NEAR(radii[0], 10.5, 5e-3);
  EXPECT_NEAR(radii[1], 19.5, 5e-3);
  EXPECT_NEAR(radii[2], 11.5, 5e-3);
  EXPECT_NEAR(radii[3], 18.5, 5e-3);
  EXPECT_EQ(runs[1].role, PathRole::OuterWall);
  EXPECT_EQ(runs[2].role, PathRole::InnerWall);
}

TEST(Perimeters, GoFromTheOutsideInOrBackOrInTurn) {
  const auto radii = [](PerimeterOrder order, std::size_t layer) {
    InfillRequest request = circleRequest(PerimeterOffset::Robust);
    request.settings.perimeters.order = order;
    request.layer = layer;
    std::vector<double> result;
    for (const FillPath& run : perimeters(disc(), request)) result.push_back(radiusOf(run));
    return result;
  };
  const std::vector<double> inwards = radii(PerimeterOrder::OutsideIn, 1);
  EXPECT_TRUE(std::is_sorted(inwards.rbegin(), inwards.rend()));
  const std::vector<double> outwards = radii(PerimeterOrder::InsideOut, 0);
  EXPECT_TRUE(std::is_sorted(outwards.begin(), outwards.end()));
  const std::vector<double> even = radii(PerimeterOrder::Alternating, 4);
  EXPECT_TRUE(std::is_sorted(even.rbegin(), even.rend()));
  const std::vector<double> odd = radii(PerimeterOrder::Alternating, 5);
  EXPECT_TRUE(std::is_sorted(odd.begin(), odd.end()));
}

/// A start that moves on [Flores2018, section 6.1.2], on a square of which the outermost perimeter is 36 mm
/// round.
TEST(Perimeters, StartFartherAlongInEachLayer) {
  InfillRequest request = perimetersSolid(1.0);
  request.settings.perimeters.count = 2;
  request.settings.perimeters.seam_step = 2.0;
  const std::vector<Point2> outer_starts = {{0.5, 0.5}, {2.5, 0.5}, {4.5, 0.5}, {6.5, 0.5},
                                            {8.5, 0.5}, {9.5, 1.5}, {9.5, 3.5}};
  for (request.layer = 0; request.layer < outer_starts.size(); ++request.layer) {
    const std::vector<FillPath> runs = perimeters({{rectangle(0, 0, 10, 10), {}}}, request);
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_LT((runs[0].points.front() - outer_starts[request.layer]).norm(), 1e-4) << request.layer;
  }
  request.layer = 0;
  EXPECT_LT(
      (perimeters({{rectangle(0, 0, 10, 10), {}}}, request)[1].points.front() - Point2(3.5, 1.5)).norm(),
      1e-4)
      << "a step farther than the one outside";
}

/// A start at random [Flores2018, section 6.2.1].
TEST(Perimeters, StartAtRandomPlacesOfTheirSeed) {
  const auto starts = [](int seed, std::size_t layer) {
    InfillRequest request = circleRequest(PerimeterOffset::Robust);
    request.settings.perimeters.seam = PerimeterSeam::Random;
    request.settings.perimeters.seed = seed;
    request.layer = layer;
    std::vector<Point2> result;
    for (const FillPath& run : perimeters(disc(), request)) result.push_back(run.points.front());
    return result;
  };
  EXPECT_EQ(starts(1, 5), starts(1, 5));
  EXPECT_NE(starts(1, 5), starts(2, 5));
  EXPECT_NE(starts(1, 5), starts(1, 6));
  EXPECT_GT((starts(1, 5)[0].normalized() - starts(1, 5)[1].normalized()).norm(), 1e-3)
      << "each perimeter starts elsewhere";
}

TEST(Perimeters, AreDepositedOnlyWhereTheirBeadHasRoom) {
  InfillRequest request = perimetersSolid(1.0);
  request.settings.perimeters.count = 9;
  EXPECT_EQ(perimeters({{rectangle(0, 0, 30, 4), {}}}, request).size(), 2U) << "four beads fit exactly";
  EXPECT_EQ(perimeters({{rectangle(0, 0, 30, 5), {}}}, request).size(), 2U);
  EXPECT_TRUE(perimeters({{rectangle(0, 0, 30, 1.5), {}}}, request).empty());
}

TEST(Perimeters, AsManyAsFitLeaveTheNarrowRestToBeads) {
  const std::vector<FillPath> runs = perimeters({{rectangle(0, 0, 30, 3.4), {}}}, perimetersSolid(1.0));
  const auto gap_fills = std::count_if(runs.begin(), runs.end(),
                                       [](const FillPath& run) { return run.role == PathRole::GapFill; });
  EXPECT_EQ(gap_fills, 1) << "1.4 pitches are left inside one perimeter";
  EXPECT_EQ(runs.size(), 2U);
  double filled = 0.0;
  for (const FillPath& run : runs) {
    filled += run.width_mm.empty() ? length(run.points) : 0.0;
    for (std::size_t i = 1; i < run.width_mm.size(); ++i)
      filled += run.width_mm[i] * (run.points[i] - run.points[i - 1]).norm();
  }
  EXPECT_NEAR(filled, 102.0, 3.0) << "gaps at the ends and half a bead at either end of the middle one";
}

TEST(Perimeters, AreClosedWithoutAGap) {
  InfillRequest request = circleRequest(PerimeterOffset::Robust);
  request.settings.perimeters.end_gap = 0.0;
  const std::vector<FillPath> runs = perimeters(disc(), request);
  ASSERT_FALSE(runs.empty());
  for (const FillPath& run : runs) EXPECT_TRUE(run.is_closed);
}

}  // namespace
}  // namespace lamina
