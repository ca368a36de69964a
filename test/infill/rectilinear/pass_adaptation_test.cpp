// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/pass_adaptation.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;

HybridSettings settingsOf(LongitudinalAdaptation longitudinal) {
  HybridSettings settings;
  settings.longitudinal = longitudinal;
  return settings;
}

/// Least distance of a pass end from the border of a disc [spacings of 2 mm].
double worstClearance(const std::vector<GridSection>& sections, double radius) {
  double least = std::numeric_limits<double>::infinity();
  for (const GridSection& section : sections)
    for (const Polyline& pass : section.passes)
      for (const Point2& end : pass) least = std::min(least, (radius - end.norm()) / 2.0);
  return least;
}

/// A circle: 252 points from +x, radius 20 mm.
const Polygon& contour() {
  static const Polygon points = circle({0, 0}, 20.0, 252);
  return points;
}

std::vector<GridSection> circleSections() { return gridSections({contour()}, 2.0, {0.2, 0.2}); }

/// Ends of passes in the circle, cut by the perimeter offset inwards.
TEST(LongitudinalAdaptation, ClippedPutsAllEndsAtTheirDistance) {
  const PerimeterApproach perimeter({contour()}, 2.0, settingsOf(LongitudinalAdaptation::Clipped));
  std::vector<GridSection> sections = circleSections();
  adaptLongitudinally(sections, perimeter);
  ASSERT_EQ(sections.size(), 1U);
  EXPECT_EQ(sections[0].passes.size(), 18U);
  for (const Polyline& pass : sections[0].passes)
    for (const Point2& end : pass) EXPECT_NEAR((20.0 - end.norm()) / 2.0, 1.0, 1e-3);
}

/// Ends of passes in the circle, moved as in [Flores2018, figures 56 to 59].
TEST(LongitudinalAdaptation, NeedsASecondPass) {
  const PerimeterApproach perimeter({contour()}, 2.0, settingsOf(LongitudinalAdaptation::TwoPass));
  std::vector<GridSection> once = circleSections();
  for (GridSection& section : once)
    for (Polyline& pass : section.passes)
      pass = {perimeter.approached(pass.front(), {-1, 0}, 1), perimeter.approached(pass.back(), {1, 0}, 1)};
  EXPECT_NEAR(worstClearance(once, 20.0), 0.810, 0.002);
  std::vector<GridSection> twice = circleSections();
  adaptLongitudinally(twice, perimeter);
  EXPECT_NEAR(worstClearance(twice, 20.0), 0.994, 0.002);
}

TEST(LongitudinalAdaptation, LeavesAnEndWhosePerimeterIsBesideIt) {
  const PerimeterApproach perimeter({rectangle(0, 0, 40, 20)}, 2.0,
                                    settingsOf(LongitudinalAdaptation::TwoPass));
  EXPECT_EQ(perimeter.approached({20.0, 16.9}, {1, 0}), Point2(20.0, 16.9)) << "3.1 mm below the border";
}

/// For [Flores2018, figures 60 to 63]: a stack of passes from y = 0 down, `gap` spacings of 2 mm below the
/// straight border of a wide rectangle.
class Transversal : public testing::TestWithParam<LongitudinalAdaptation> {
 protected:
  GridSection adapted(double gap) const {
    const PerimeterApproach perimeter({rectangle(-20, -60, 20, 2.0 * gap)}, 2.0, settingsOf(GetParam()));
    GridSection section;
    for (int i = 5; i >= 0; --i) section.passes.push_back({{-10.0, -2.0 * i}, {10.0, -2.0 * i}});
    section.is_bordered_above = true;
    std::vector<GridSection> sections = {section};
    adaptTransversally(sections, perimeter);
    return sections[0];
  }

  /// From the curve that was added to the pass below, in spacings.
  static double gapBelowCurve(const GridSection& section) {
    const std::size_t count = section.passes.size();
    return (section.passes[count - 1].front().y() - section.passes[count - 2].front().y()) / 2.0;
  }
};

TEST_P(Transversal, AddsACurveWhereThePerimeterIsFar) {
  const GridSection section = adapted(1.9);
  EXPECT_EQ(section.passes.size(), 7U);
  EXPECT_EQ(section.passes.back().size(), 20U);
  EXPECT_NEAR(gapBelowCurve(section), 0.9, 1e-3);
  EXPECT_FALSE(section.above);
}

TEST_P(Transversal, AddsACurveJustAboveItsThreshold) {
  const GridSection section = adapted(1.5001);
  EXPECT_EQ(section.passes.size(), 7U);
  EXPECT_NEAR(gapBelowCurve(section), 0.5, 1e-3);
}

TEST_P(Transversal, ReplacesAPassThatIsTooNear) {
  const GridSection section = adapted(1.1);
  EXPECT_EQ(section.passes.size(), 6U);
  EXPECT_NEAR(gapBelowCurve(section), 1.1, 1e-3) << "from y = -2 to 0.2";
}

TEST_P(Transversal, AddsOnePointInBetween) {
  const GridSection section = adapted(1.35);
  EXPECT_EQ(section.passes.size(), 6U);
  ASSERT_TRUE(section.above);
  EXPECT_NEAR(section.above->y(), 0.7, 1e-3) << "one spacing of 2 mm below the border at 2.7";
}

TEST_P(Transversal, LeavesNoGapBelowHalfASpacingNorAboveOneAndAHalf) {
  for (double gap = 1.01; gap < 1.999; gap += 0.01) {
    const GridSection section = adapted(gap);
    const Point2 outermost = section.above.value_or(section.passes.back().front());
    const double to_border = (2.0 * gap - outermost.y()) / 2.0;
    EXPECT_GE(to_border, 0.5) << "D is " << gap;
    EXPECT_LE(to_border, 1.5) << "D is " << gap;
    EXPECT_GE(gapBelowCurve(section), 0.5 - 1e-6) << "D is " << gap;
    EXPECT_LE(gapBelowCurve(section), 1.5 + 1e-6) << "D is " << gap;
  }
}

TEST_P(Transversal, ReplacesAPassThatIsAPoint) {
  const PerimeterApproach perimeter({rectangle(-20, -60, 20, 3.0)}, 2.0, settingsOf(GetParam()));
  GridSection section;
  section.passes = {{{-10, -4}, {10, -4}}, {{-10, -2}, {10, -2}}, {{0, 0}}};
  section.is_bordered_above = true;
  std::vector<GridSection> sections = {section};
  adaptTransversally(sections, perimeter);
  ASSERT_EQ(sections[0].passes.size(), 3U);
  EXPECT_NEAR(gapBelowCurve(sections[0]), 1.5, 1e-3) << "from y = -2 to 1";
}

TEST_P(Transversal, EndsCurvesShortOfThePassBeside) {
  const GridSection section = adapted(1.9);
  EXPECT_NEAR(section.passes.back().front().x(), -9.0, 1e-9) << "half a spacing of 2 mm";
  EXPECT_NEAR(section.passes.back().back().x(), 9.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Modes, Transversal,
                         testing::Values(LongitudinalAdaptation::TwoPass, LongitudinalAdaptation::Clipped),
                         [](const testing::TestParamInfo<LongitudinalAdaptation>& mode) {
                           return mode.param == LongitudinalAdaptation::Clipped ? "Clipped" : "TwoPass";
                         });

/// A rectangle of 40 x 20 mm, seen along its passes: they run along y of the part, which is x here.
std::vector<GridSection> rectangleSections(LongitudinalAdaptation longitudinal) {
  const Polygon perimeter = rectangle(0, 0, 20, 40);
  std::vector<GridSection> sections = gridSections({perimeter}, 2.0, {0.2, 0.2});
  const PerimeterApproach approach({perimeter}, 2.0, settingsOf(longitudinal));
  adaptLongitudinally(sections, approach);
  adaptTransversally(sections, approach);
  return sections;
}

TEST(PassAdaptation, FitsNineteenPassesIntoARectangle) {
  const std::vector<GridSection> sections = rectangleSections(LongitudinalAdaptation::Clipped);
  ASSERT_EQ(sections.size(), 1U);
  const std::vector<Polyline>& passes = sections[0].passes;
  ASSERT_EQ(passes.size(), 19U);
  EXPECT_NEAR(passes.front()[0].y(), 2.0, 1e-6);
  EXPECT_NEAR(passes[1][0].y(), 4.2, 1e-9);
  EXPECT_NEAR(passes[17][0].y(), 36.2, 1e-9);
  EXPECT_NEAR(passes.back()[0].y(), 38.0, 1e-6);
  for (std::size_t i = 1; i + 1 < passes.size(); ++i) {
    EXPECT_NEAR(passes[i].front().x(), 2.0, 1e-6);
    EXPECT_NEAR(passes[i].back().x(), 18.0, 1e-6);
  }
}

/// The same rectangle, its ends moved as in [Flores2018, figures 56 to 59].
TEST(PassAdaptation, InTwoPassesLeavesOneEndInTheCornerBehind) {
  const std::vector<GridSection> sections = rectangleSections(LongitudinalAdaptation::TwoPass);
  ASSERT_EQ(sections.size(), 1U);
  EXPECT_EQ(sections[0].passes.size(), 19U);
  EXPECT_NEAR(sections[0].passes[17].back().x(), 16.2, 1e-9);
}

}  // namespace
}  // namespace lamina
