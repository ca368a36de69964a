// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/variable_width_runs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::reversed;

InfillRequest variableWidthRunsSolid(double pitch, double angle_rad) {
  InfillRequest request;
  request.pitch_mm = request.spacing_mm = pitch;
  request.angle_rad = angle_rad;
  return request;
}

std::vector<FillPath> variableWidthRunsFilled(const Regions& area, const InfillRequest& request) {
  return variableWidthRuns(offset(area, -0.5 * narrowestBead(request)), request);
}

/// Area that beads fill [mm²].
double variableWidthRunsFilledArea(const std::vector<FillPath>& runs) {
  double sum = 0.0;
  for (const FillPath& run : runs)
    for (std::size_t i = 1; i < run.points.size(); ++i)
      sum += run.width_mm[i] * (run.points[i] - run.points[i - 1]).norm();
  return sum;
}

Regions randomRegions(Random& random) {
  return unite({test::star(random, {0, 0}, 7.0, 12.0, 40), reversed(test::star(random, {1, 0}, 1.0, 4.0, 12)),
                test::star(random, {30, 5}, 2.0, 6.0, 9)});
}

TEST(VariableWidthRuns, DivideARectangleEvenly) {
  // 4.3 mm across are 11 variable-width lines of 0.391 mm.
  const std::vector<FillPath> runs =
      variableWidthRunsFilled({{rectangle(0, 0, 20, 4.3), {}}}, variableWidthRunsSolid(0.4, 0.0));
  ASSERT_EQ(runs.size(), 1U);
  double longest = 0.0;
  for (std::size_t i = 1; i < runs[0].points.size(); ++i) {
    const Point2 motion = runs[0].points[i] - runs[0].points[i - 1];
    if (motion.norm() < 10.0) continue;
    longest = std::max(longest, motion.norm());
    EXPECT_NEAR(runs[0].width_mm[i], 4.3 / 11, 1e-6);
    EXPECT_NEAR(std::remainder(runs[0].points[i].y() / (4.3 / 11) - 0.5, 1.0), 0.0, 1e-6);
  }
  EXPECT_GT(longest, 19.0);
  EXPECT_NEAR(variableWidthRunsFilledArea(runs), 20 * 4.3, 0.02 * 20 * 4.3);
}

TEST(VariableWidthRuns, FillEachConvexRegionInOneRun) {
  for (const double angle : {0.0, 0.4, 1.1}) {
    EXPECT_EQ(
        variableWidthRunsFilled({{circle({0, 0}, 9, 80), {}}}, variableWidthRunsSolid(0.4, angle)).size(),
        1U);
    EXPECT_EQ(
        variableWidthRunsFilled({{rectangle(0, 0, 13, 7), {}}}, variableWidthRunsSolid(0.4, angle)).size(),
        1U);
  }
}

TEST(VariableWidthRuns, TaperTowardsABorderThatIsSlanted) {
  const std::vector<FillPath> runs =
      variableWidthRunsFilled({{{{0, 0}, {30, 0}, {10, 4}, {0, 4}}, {}}}, variableWidthRunsSolid(0.5, 0.0));
  ASSERT_EQ(runs.size(), 1U);
  const auto [least, greatest] = std::minmax_element(runs[0].width_mm.begin() + 1, runs[0].width_mm.end());
  EXPECT_NEAR(*least, 0.3 * 0.5, 1e-9) << "the narrowest bead";
  EXPECT_LE(*greatest, 0.5005) << "and what is left of the turns' jogs";
  EXPECT_NEAR(variableWidthRunsFilledArea(runs), 80.0, 0.02 * 80.0);
}

TEST(VariableWidthRuns, NarrowUnderAHoleThatComesIntoTheirStrip) {
  const Regions plate = {{rectangle(0, 0, 20, 10), {reversed(rectangle(5, 4.3, 15, 7))}}};
  const std::vector<FillPath> runs = variableWidthRunsFilled(plate, variableWidthRunsSolid(0.5, 0.0));
  EXPECT_NEAR(variableWidthRunsFilledArea(runs), area(plate), 0.02 * area(plate));
}

TEST(VariableWidthRuns, StayInsideAndFillWhatTheyCover) {
  EXPECT_TRUE(rc::check("random regions", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = randomRegions(random);
    const std::vector<Polygon> borders = outlines(regions);
    const InfillRequest request = variableWidthRunsSolid(random.uniform(0.3, 1.0), random.uniform(-7.0, 7.0));
    const std::vector<FillPath> runs = variableWidthRunsFilled(regions, request);
    for (const FillPath& run : runs) {
      RC_ASSERT(run.points.size() == run.width_mm.size());
      for (std::size_t i = 1; i < run.points.size(); ++i) {
        RC_ASSERT(run.width_mm[i] > 0.0 && run.width_mm[i] <= 1.6 * 1.5 * request.pitch_mm);
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          const Point2 point = run.points[i - 1] + t * (run.points[i] - run.points[i - 1]);
          RC_ASSERT(point.allFinite());
          RC_ASSERT(contains(borders, point) ||
                    test::distanceToOutline(borders, point) < 0.5 * narrowestBead(request));
        }
      }
    }
    RC_ASSERT(std::abs(variableWidthRunsFilledArea(runs) / area(regions) - 1.0) < 0.03);
  }));
}

/// The diagonal of the square, 28.28 mm, is 71 lines: 70 turns lead from one to the next, each back at most
/// once. They fill as much as with the two turns more that each of them took.
TEST(VariableWidthRuns, TurnBackOnceFromLineToLine) {
  const std::vector<FillPath> runs =
      variableWidthRunsFilled({{rectangle(0, 0, 20, 20), {}}}, variableWidthRunsSolid(0.4, M_PI / 4));
  ASSERT_EQ(runs.size(), 1U);
  const Polyline& points = runs[0].points;
  int turns = 0;
  for (std::size_t i = 2; i < points.size(); ++i)
    if ((points[i - 1] - points[i - 2]).dot(points[i] - points[i - 1]) < 0.0) ++turns;
  EXPECT_LE(turns, 70);
  EXPECT_NEAR(variableWidthRunsFilledArea(runs), 400.0, 0.005 * 400.0);
}

TEST(VariableWidthRuns, OfNothingAreNone) {
  EXPECT_TRUE(variableWidthRuns({}, variableWidthRunsSolid(0.4, 0.0)).empty());
  EXPECT_TRUE(
      variableWidthRunsFilled({{rectangle(0, 0, 5, 0.1), {}}}, variableWidthRunsSolid(0.4, 0.0)).empty());
}

}  // namespace
}  // namespace lamina
