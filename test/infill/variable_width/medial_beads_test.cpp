// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/medial_beads.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "infill/variable_width/skeleton_beads.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;

/// Axes are straightened by 0.01 pitches [mm].
constexpr double kTolerance = 0.01;

MedialBeadSettings pitchOf(double pitch_mm) {
  MedialBeadSettings settings;
  settings.pitch_mm = pitch_mm;
  return settings;
}

/// What the run fills, its round ends not counted [mm²].
double medialBeadsFilledArea(const FillPath& run) {
  double sum = 0.0;
  for (std::size_t i = run.is_closed ? 0 : 1; i < run.points.size(); ++i) {
    const Point2& from = i == 0 ? run.points.back() : run.points[i - 1];
    sum += (run.points[i] - from).norm() * run.width_mm[i];
  }
  return sum;
}

TEST(MedialBeads, FillANarrowPlaceByOneRunAsWideAsItIs) {
  const std::vector<FillPath> runs = medialBeads({{rectangle(0, 0, 10, 0.5), {}}}, pitchOf(0.4));
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_FALSE(runs[0].is_closed);
  EXPECT_EQ(runs[0].role, PathRole::GapFill);
  EXPECT_NEAR(length(runs[0].points), 9.5, kTolerance);
  for (const double width : runs[0].width_mm) EXPECT_NEAR(width, 0.5, kTolerance);
  for (const Point2& point : runs[0].points) EXPECT_NEAR(point.y(), 0.25, kTolerance);
}

TEST(MedialBeads, FillAPlaceOfTwoBeadsThereAndBack) {
  const std::vector<FillPath> runs = medialBeads({{rectangle(0, 0, 10, 0.8), {}}}, pitchOf(0.4));
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_TRUE(runs[0].is_closed);
  for (const double width : runs[0].width_mm) EXPECT_NEAR(width, 0.4, kTolerance);
  EXPECT_NEAR(medialBeadsFilledArea(runs[0]), 8.0, 0.05);  // as a rectangle of beads fills it exactly
}

TEST(MedialBeads, ChangeFromOneBeadToTwoWhereAWedgeGetsThickerThanOneCanFill) {
  const Region wedge = {{{0, 0}, {20, -0.5}, {20, 0.5}}, {}};  // T is about x / 20
  for (const FillPath& run : medialBeads({wedge}, pitchOf(0.4)))
    for (std::size_t i = 1; i < run.points.size(); ++i) {
      EXPECT_LE(run.width_mm[i], 1.6 * 0.4 + kTolerance);
      EXPECT_GE(run.width_mm[i], 0.3 * 0.4 - kTolerance);
      const double thickness = run.points[i].x() / 20.0;
      const double aside = thickness < 1.55 * 0.4 ? 0.0 : thickness > 1.65 * 0.4 ? thickness / 4.0 : -1.0;
      EXPECT_TRUE(aside < 0.0 || std::abs(std::abs(run.points[i].y()) - aside) < kTolerance)
          << run.points[i].transpose();
    }
}

TEST(MedialBeads, EndWhereAWedgeIsThinnerThanTheLeastWidth) {
  const Region wedge = {{{0, 0}, {20, -0.25}, {20, 0.25}}, {}};  // T is about x / 40
  const std::vector<FillPath> runs = medialBeads({wedge}, pitchOf(0.4));
  ASSERT_EQ(runs.size(), 1U);
  double first = 20.0;
  for (const Point2& point : runs[0].points) first = std::min(first, point.x());
  EXPECT_NEAR(first, 0.3 * 0.4 * 40.0, 0.1);
}

TEST(MedialBeads, OfARingCloseOnThemselves) {
  const Region loop = {circle({0, 0}, 5.25, 90), {test::reversed(circle({0, 0}, 4.75, 90))}};
  const std::vector<FillPath> runs = medialBeads({loop}, pitchOf(0.4));
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_TRUE(runs[0].is_closed);
  EXPECT_NEAR(medialBeadsFilledArea(runs[0]), area({loop}), 0.01 * area({loop}));
}

TEST(MedialBeads, OfACrossGoStraightOnWhereItsArmsMeet) {
  const Regions cross = unite({rectangle(-5, -0.2, 5, 0.2), rectangle(-0.2, -5, 0.2, 5)});
  EXPECT_EQ(medialBeads(cross, pitchOf(0.4)).size(), 3U);  // through, and an arm on each side
}

TEST(MedialBeads, OfADiscSmallerThanABeadGoAcrossItAsWideAsItIs) {
  const std::vector<FillPath> runs = medialBeads({{circle({1, 2}, 0.2, 40), {}}}, pitchOf(0.4));
  ASSERT_EQ(runs.size(), 1U);
  // From where 0.3 pitches have room to the same on the other side; the middle as wide as the disc.
  const Point2 along = runs[0].points.back() - runs[0].points.front();
  EXPECT_NEAR(along.norm(), 2.0 * (0.2 - 0.06), kTolerance);
  EXPECT_NEAR((0.5 * (runs[0].points.front() + runs[0].points.back()) - Point2(1, 2)).norm(), 0.0,
              kTolerance);
  EXPECT_NEAR(*std::max_element(runs[0].width_mm.begin(), runs[0].width_mm.end()), 0.4, 0.05);
}

TEST(MedialBeads, OfASquareGoAlongItsDiagonal) {
  const std::vector<FillPath> runs = medialBeads({{rectangle(0, 0, 0.5, 0.5), {}}}, pitchOf(0.4));
  ASSERT_EQ(runs.size(), 1U);
  const Point2 along = runs[0].points.back() - runs[0].points.front();
  EXPECT_NEAR(along.norm(), std::sqrt(2.0) * (0.5 - 0.12), kTolerance);
  EXPECT_NEAR(std::abs(along.x()), std::abs(along.y()), kTolerance);
}

TEST(MedialBeads, OfHalfADiscGoFromCornerToCorner) {
  Polygon half = circle({0, 0}, 0.5, 64);
  half.erase(std::remove_if(half.begin(), half.end(), [](const Point2& p) { return p.y() < -1e-9; }),
             half.end());
  const std::vector<FillPath> runs = medialBeads(unite({half}), pitchOf(0.4));
  ASSERT_EQ(runs.size(), 1U);
  const Point2 along = runs[0].points.back() - runs[0].points.front();
  // A disc of radius 0.06 in each corner.
  const double reach = std::sqrt(std::pow(0.5 - 0.06, 2) - 0.06 * 0.06);
  EXPECT_NEAR(along.norm(), 2.0 * reach, 2.0 * kTolerance);
}

TEST(MedialBeads, BecomeNoWiderWhereTwoLanesAreJoined) {
  const double radius = 0.75;
  Polygon half = circle({0, 0}, radius, 64);
  half.erase(std::remove_if(half.begin(), half.end(), [](const Point2& p) { return p.y() < -1e-9; }),
             half.end());
  for (const FillPath& run : medialBeads(unite({half}), pitchOf(0.36)))
    for (std::size_t i = 1; i < run.points.size(); ++i)
      for (const Point2& point : {run.points[i - 1], run.points[i]})
        EXPECT_LE(0.5 * run.width_mm[i], std::min(point.y(), radius - point.norm()) + 0.05)
            << point.transpose();
}

TEST(MedialBeads, LayNothingWhereThereIsLessThanTheLeastWidth) {
  EXPECT_TRUE(medialBeads({}, pitchOf(0.4)).empty());
  EXPECT_TRUE(medialBeads({Region{}}, pitchOf(0.4)).empty());
  EXPECT_TRUE(medialBeads({{rectangle(0, 0, 10, 0.1), {}}}, pitchOf(0.4)).empty());
}

TEST(MedialBeads, RefuseAPitchOfNothing) {
  EXPECT_THROW(medialBeads({}, pitchOf(0.0)), InvalidInput);
  EXPECT_THROW(medialLoops({}, pitchOf(-1.0)), InvalidInput);
}

TEST(MedialLoops, GoOutAndBackHalfTheThicknessWide) {
  const std::vector<FillPath> runs = medialLoops({{rectangle(0, 0, 10, 0.6), {}}}, pitchOf(0.4));
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_TRUE(runs[0].is_closed);
  EXPECT_GT(signedArea(runs[0].points), 0.0);
  for (const double width : runs[0].width_mm) EXPECT_NEAR(width, 0.3, kTolerance);
  for (const Point2& point : runs[0].points) EXPECT_LE(std::abs(point.y() - 0.3), 0.15 + kTolerance);
  EXPECT_NEAR(medialBeadsFilledArea(runs[0]), 6.0, 0.2);
}

TEST(MedialLoops, GoRoundAllArmsOfACrossAtOnce) {
  const Regions cross = unite({rectangle(-5, -0.3, 5, 0.3), rectangle(-0.3, -5, 0.3, 5)});
  const std::vector<FillPath> runs = medialLoops(cross, pitchOf(0.4));
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_NEAR(medialBeadsFilledArea(runs[0]), area(cross), 0.05 * area(cross));
}

TEST(MedialLoops, OfARingAreOneOutsideAndOneInside) {
  const Region loop = {circle({0, 0}, 5.3, 90), {test::reversed(circle({0, 0}, 4.7, 90))}};
  EXPECT_EQ(medialLoops({loop}, pitchOf(0.4)).size(), 2U);
}

/// Squares, discs and stars of so many pitches.
Regions randomPlace(Random& random, double pitches) {
  const double size = 0.4 * pitches;
  switch (static_cast<int>(random.uniform(0.0, 3.0))) {
    case 0:
      return {{rectangle(0, 0, size, size), {}}};
    case 1:
      return {{circle({0, 0}, 0.5 * size, 48), {}}};
    default:
      return unite({test::star(random, {0, 0}, 0.2 * size, 0.5 * size, 11)});
  }
}

TEST(MedialBeads, AreNowhereWiderThanTheWidest) {
  EXPECT_TRUE(rc::check("places of any size", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions place = randomPlace(random, random.uniform(1.0, 50.0));
    for (const FillPath& run : medialBeads(place, pitchOf(0.4)))
      for (const double width : run.width_mm) RC_ASSERT(width <= 1.6 * 0.4 + 1e-9);
  }));
}

TEST(MedialBeads, GoRoundTheMiddleOfWhatIsTooWideForABeadButNoLonger) {
  for (const double radius : {0.5, 2.0}) {
    double filled = 0.0;
    for (const FillPath& run : skeletonBeads({{{{1, 2}, radius}}}, pitchOf(0.4))) {
      for (const double width : run.width_mm) EXPECT_LE(width, 1.6 * 0.4);
      filled += medialBeadsFilledArea(run);
    }
    EXPECT_NEAR(filled, M_PI * radius * radius, 0.05 * M_PI * radius * radius);
  }
}

TEST(MedialRuns, StayInsideTheRegion) {
  EXPECT_TRUE(rc::check("random narrow regions", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions whole = unite({test::star(random, {0, 0}, 3.0, 12.0, 14)});
    const Regions narrow = difference(whole, offset(whole, -random.uniform(0.1, 0.5)));
    const std::vector<Polygon> borders = outlines(narrow);
    for (const auto& fill : {medialBeads, medialLoops})
      for (const FillPath& run : fill(narrow, pitchOf(0.4))) {
        RC_ASSERT(run.points.size() >= 2U);
        RC_ASSERT(run.points.size() == run.width_mm.size());
        for (const Point2& point : run.points)
          RC_ASSERT(contains(borders, point) || test::distanceToOutline(borders, point) < kTolerance);
      }
  }));
}

}  // namespace
}  // namespace lamina
