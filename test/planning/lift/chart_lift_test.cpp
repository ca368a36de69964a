// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/lift/chart_lift.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"
#include "planning/nozzle_frame.hpp"
#include "support/charts.hpp"
#include "support/path_spacing.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::halfCylinder;
using test::levelChart;
using test::polarCap;
using test::straightPath;

constexpr double kRadius = 10.0;
constexpr double kTip = kRadius + 0.5 * test::kChartHeight;
constexpr std::uint32_t kSides = 90;

Path line(const Point2& from, const Point2& to) {
  return straightPath({from.x(), from.y(), 0.2}, {to.x(), to.y(), 0.2});
}

std::vector<Path> lift(const LayerChart& chart, std::vector<Path> planned,
                       const LiftSettings& settings = {}) {
  return liftOnto({chart}, {0.2, 0.2, std::move(planned)}, settings, {}, kTip).layer.paths;
}

/// The middle of the plan of the half cylinder.
const Point2 kTop(0.5 * M_PI * kRadius, 10.0);

TEST(ChartLift, LaysALineAlongAGeneratorWithItsTwoWaypointsOnly) {
  const Path path = lift(halfCylinder(kRadius, 20.0, kSides), {line({5.0, 1.0}, {5.0, 19.0})}).front();
  ASSERT_EQ(path.points.size(), 2U);
  EXPECT_NEAR(length(path), 18.0, 1e-12);
  EXPECT_TRUE(path.orientation.isCommon());
  EXPECT_TRUE(path.bead.isCommon());
}

TEST(ChartLift, FollowsTheArcOfACylinderWithinTheTolerances) {
  const LayerChart chart = halfCylinder(kRadius, 20.0, kSides);
  const Path path = lift(chart, {line({1.0, 5.0}, {30.0, 5.0})}).front();
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const Point3 radial(path.points[i].x(), 0.0, path.points[i].z());
    EXPECT_GE(radial.norm(), kTip * std::cos(0.5 * M_PI / kSides) - 1e-9);
    EXPECT_LE(radial.norm(), kTip + 1e-9);
    EXPECT_NEAR((againstToolAxis(path.orientation.at(i)) - radial.normalized()).norm(), 0.0, 1e-9);
  }
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Point3 middle = 0.5 * (path.points[i - 1] + path.points[i]);
    EXPECT_GE(Point2(middle.x(), middle.z()).norm(), kTip * std::cos(0.5 * M_PI / kSides) - 0.005);
  }
  // The arc is as long as the plan says on the middle, and longer at the tips.
  EXPECT_NEAR(length(path), 29.0 * kTip / kRadius, 29.0 * 1e-4);
}

TEST(ChartLift, TakesWiderStepsWhereTolerancesAreWider) {
  LiftSettings loose;
  loose.position_tolerance_mm = 0.05;
  loose.normal_tolerance_deg = 5.0;
  const LayerChart chart = halfCylinder(kRadius, 20.0, 720);
  const std::size_t fine = lift(chart, {line({1.0, 5.0}, {30.0, 5.0})}).front().points.size();
  const std::size_t coarse = lift(chart, {line({1.0, 5.0}, {30.0, 5.0})}, loose).front().points.size();
  EXPECT_LT(coarse, fine / 2);
  // A chord of a circle that leaves it by 0.05 mm is 2 mm long.
  EXPECT_GE(coarse, 29.0 * kTip / kRadius / 2.1);
}

TEST(ChartLift, KeepsTheVolumeOnWhatIsDevelopable) {
  const LayerChart chart = halfCylinder(kRadius, 20.0, kSides);
  EXPECT_TRUE(rc::check([&] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const auto point = [&] { return Point2(random.uniform(0.5, 31.0), random.uniform(0.5, 19.5)); };
    Path path = line(point(), point());
    for (int i = 0; i < 5; ++i) path.points.emplace_back(point().x(), point().y(), 0.2);
    path.is_closed = random.below(2) == 0;
    const Path lifted = lift(chart, {path}).front();
    RC_ASSERT(lifted.is_closed == path.is_closed);
    RC_ASSERT(std::abs(depositedVolume(lifted) / depositedVolume(path) - 1.0) <= 1e-9);
  }));
}

/// Volume deposited on the annulus between two parallels of the sphere by circles of the plan, per volume of
/// the layer there.
double shareOnAnnulus(double from, double to) {
  const LayerChart chart = polarCap(kRadius, 0.5 * M_PI, 90, 180);
  const double pitch = (to - from) * kRadius / 40;
  double deposited = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double radius = kRadius * from + (i + 0.5) * pitch;
    Path circle;
    circle.is_closed = true;
    circle.feed_mm_s = 10.0;
    circle.bead = beadOfArea(pitch * 0.2, 0.2);
    for (int k = 0; k < 360; ++k)
      circle.points.emplace_back(radius * std::cos(k * M_PI / 180), radius * std::sin(k * M_PI / 180), 0.2);
    deposited += depositedVolume(lift(chart, {circle}).front());
  }
  const double area = 2.0 * M_PI * kRadius * kRadius * (std::cos(from) - std::cos(to));
  return deposited / (area * test::kChartHeight);
}

TEST(ChartLift, FillsTheAreaOfASphereWhateverItsPlanMakesOfIt) {
  EXPECT_NEAR(shareOnAnnulus(0.2, 0.4), 1.0, 2e-3);
  EXPECT_NEAR(shareOnAnnulus(1.0, 1.2), 1.0, 2e-3);
}

TEST(ChartLift, MakesBeadsAsHighAsTheLayer) {
  LayerChart wedge = levelChart(10.0, 1);
  for (std::size_t i = 0; i < wedge.parameterization.size(); ++i)
    wedge.surface.height_mm[i] = 0.1 + 0.02 * wedge.parameterization[i].x();
  const Path path = lift(wedge, {line({0.0, 5.0}, {10.0, 5.0})}).front();
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const double middle = 0.5 * (path.points[i - 1].x() + path.points[i].x());
    EXPECT_NEAR(path.bead.at(i).height_mm, 0.1 + 0.02 * middle, 1e-9);
    EXPECT_LE((path.points[i] - path.points[i - 1]).x() * 0.02, 0.05 * path.bead.at(i).height_mm);
    EXPECT_NEAR(planWidth(path.bead.at(i)), planWidth({0.4, 0.2}), 1e-9);
  }
  EXPECT_NEAR(depositedVolume(path), planWidth({0.4, 0.2}) * 10.0 * 0.2, 1e-9);
}

TEST(ChartLift, KeepsSpacingOnACylinderInAnyDirection) {
  const LayerChart chart = halfCylinder(kRadius, 20.0, 180);
  for (const double heading : {0.0, 0.3, 0.8, 1.2, 0.5 * M_PI}) {
    const Point2 along(std::cos(heading), std::sin(heading));
    const Point2 across(-along.y(), along.x());
    const std::vector<Path> lines =
        lift(chart, {line(kTop - 8.0 * along, kTop + 8.0 * along),
                     line(kTop - 9.0 * along + 0.4 * across, kTop + 9.0 * along + 0.4 * across)});
    const test::Spacing spacing = test::spacingBetween(lines[0], lines[1]);
    // Tips are farther from the axis than the middle: along the arc their spacing grows by that.
    EXPECT_GE(spacing.least_mm, 0.4 - 1e-4) << heading;
    EXPECT_LE(spacing.greatest_mm, 0.4 * kTip / kRadius + 1e-4) << heading;
  }
}

TEST(ChartLift, KeepsTheSpacingOfParallelsOfASphere) {
  const LayerChart chart = polarCap(kRadius, 0.5 * M_PI, 60, 240);
  std::vector<Path> circles;
  for (const double radius : {9.0, 9.4}) {
    circles.push_back(line({radius, 0.0}, {radius, 0.0}));
    circles.back().is_closed = true;
    circles.back().points.clear();
    for (int k = 0; k < 240; ++k)
      circles.back().points.emplace_back(radius * std::cos(k * M_PI / 120), radius * std::sin(k * M_PI / 120),
                                         0.2);
  }
  const std::vector<Path> lifted = lift(chart, circles);
  const test::Spacing spacing = test::spacingBetween(lifted[0], lifted[1]);
  EXPECT_NEAR(spacing.least_mm, 0.4 * kTip / kRadius, 1e-3);
  EXPECT_NEAR(spacing.greatest_mm, 0.4 * kTip / kRadius, 1e-3);
}

TEST(ChartLift, LaysDropsWhereTheyAreAndAsMuch) {
  Path drops = line(kTop - Point2(3, 0), kTop + Point2(3, 0));
  drops.deposit = Deposit::Drops;
  drops.bead = Bead{0.5, 0.2};
  const Path lifted = lift(halfCylinder(kRadius, 20.0, kSides), {drops}).front();
  ASSERT_EQ(lifted.points.size(), 2U);
  EXPECT_NEAR(lifted.points[0].x(), -kTip * std::sin(0.3), 2e-3);
  EXPECT_NEAR(depositedVolume(lifted), depositedVolume(drops), 1e-9);
}

TEST(ChartLift, HoldsAnUprightNozzleIfAskedTo) {
  LiftSettings upright;
  upright.tool_axis = ToolAxis::Down;
  const Path path =
      lift(halfCylinder(kRadius, 20.0, kSides), {line({1.0, 5.0}, {30.0, 5.0})}, upright).front();
  ASSERT_TRUE(path.orientation.isCommon());
  EXPECT_EQ(path.orientation.at(0).coeffs(), nozzleDown().coeffs());
}

TEST(ChartLift, KeepsFeedAndWidthOfEachMotion) {
  Path path = line({5.0, 5.0}, {15.0, 5.0});
  path.points.emplace_back(15.0, 15.0, 0.2);
  path.feed_mm_s = AlongPath<double>({1.0, 20.0, 40.0});
  path.bead = AlongPath<Bead>({Bead{}, Bead{0.4, 0.2}, Bead{0.0, 0.2}});
  const Path lifted = lift(halfCylinder(kRadius, 20.0, kSides), {path}).front();
  const std::size_t last = lifted.points.size() - 1;
  for (std::size_t i = 1; i < last; ++i) {
    EXPECT_EQ(lifted.feed_mm_s.at(i), 20.0);
    EXPECT_GT(lifted.bead.at(i).width_mm, 0.39);
  }
  EXPECT_EQ(lifted.feed_mm_s.at(last), 40.0);
  EXPECT_EQ(lifted.bead.at(last).width_mm, 0.0);
}

std::vector<Path> withTravel(const Path& first, const Path& second, bool is_retracted) {
  Path travel = straightPath(first.lastPoint(), second.firstPoint());
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  travel.process.is_retracted = is_retracted;
  return {first, travel, second};
}

TEST(ChartLift, LetsTravelsOverInfillFollowTheLayerWithoutScrapingIt) {
  const LayerChart chart = halfCylinder(kRadius, 20.0, kSides);
  const std::vector<Path> paths =
      lift(chart, withTravel(line({2.0, 2.0}, {2.0, 5.0}), line({29.0, 9.0}, {29.0, 5.0}), false));
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_FALSE(paths[1].process.is_retracted);
  const double flat = kTip * std::cos(0.5 * M_PI / kSides);
  for (std::size_t i = 1; i < paths[1].points.size(); ++i)
    for (const double part : {0.1, 0.5, 0.9}) {
      const Point3 point = paths[1].points[i - 1] + part * (paths[1].points[i] - paths[1].points[i - 1]);
      EXPECT_GE(Point2(point.x(), point.z()).norm(), flat - 1e-6);
      EXPECT_LE(Point2(point.x(), point.z()).norm(), kTip + 0.0201);
    }
  EXPECT_NO_THROW(validate({"cylinder", {{0.2, 0.2, paths}}}));
}

TEST(ChartLift, TakesRetractedTravelsOverWhatIsDeposited) {
  const std::vector<Path> paths =
      lift(halfCylinder(kRadius, 20.0, kSides),
           withTravel(line({2.0, 2.0}, {2.0, 5.0}), line({29.0, 9.0}, {29.0, 5.0}), true));
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_TRUE(paths[1].process.is_retracted);
  const TravelSettings travel;
  // Off the layer, up, over, down, onto the layer.
  ASSERT_EQ(paths[1].points.size(), 6U);
  EXPECT_NEAR(paths[1].points[2].z(), kTip + travel.hop_mm, 1e-12);
  EXPECT_NEAR(paths[1].points[3].z(), kTip + travel.hop_mm, 1e-12);
  EXPECT_NEAR((paths[1].points[1] - paths[1].points[0]).norm(), travel.hop_mm, 1e-12);
  EXPECT_NO_THROW(validate({"cylinder", {{0.2, 0.2, paths}}}));
}

TEST(ChartLift, DoesNotTravelAcrossTheGapBetweenCharts) {
  const LayerChart left = levelChart(10.0, 5);
  const std::vector<LayerChart> charts = {left, test::moved(left, {12.0, 0.0})};
  const std::vector<Path> planned = withTravel(line({1, 1}, {9, 1}), line({13, 1}, {20, 1}), false);
  const ToolpathLayer layer = liftOnto(charts, {0.2, 0.2, planned}, {}, {}, 1.0).layer;
  ASSERT_EQ(layer.paths.size(), 3U);
  EXPECT_TRUE(layer.paths[1].process.is_retracted);
}

/// A layer whose tips come together in one point: beads below it, in a hollow of that radius.
LayerChart hollow(double radius) {
  LayerChart chart = polarCap(radius, 0.5, 20, 40);
  for (Point3& tip : chart.surface.tip) tip = Point3::Zero();
  return chart;
}

double volumeOf(const std::vector<Path>& paths) {
  double sum = 0.0;
  for (const Path& path : paths) sum += depositedVolume(path);
  return sum;
}

TEST(ChartLift, LeavesOutAndCountsRunsWhoseTipsComeTogether) {
  const double radius = 10.0;
  const double along = radius * std::sin(0.5);
  const std::vector<Path> planned = {line({-4.0, 0.0}, {4.0, 0.0})};
  const LiftedLayer lifted = liftOnto({hollow(radius)}, {0.2, 0.2, planned}, {}, {}, along);
  EXPECT_TRUE(lifted.layer.paths.empty());
  // Along a meridian the plan is sin(a) / a of the cap: its integral to 0.4 is 0.39646.
  EXPECT_NEAR(lifted.left_out_mm3, depositedVolume(planned[0]) * 0.39646 / 0.4, 1e-3 * lifted.left_out_mm3);
}

/// Tips of a level layer drawn together to a strip around x = 5 of a thousandth of its width.
LayerChart pinched() {
  LayerChart chart = levelChart(10.0, 50);
  for (Point3& tip : chart.surface.tip)
    if (std::abs(tip.x() - 5.0) < 1.1) tip.x() = 5.0 + 1e-3 * (tip.x() - 5.0);
  return chart;
}

TEST(ChartLift, LaysNoBeadWiderThanAllowedAndCountsWhatItLeavesOut) {
  for (const double widest : {1.5, 2.0, 4.0}) {
    LiftSettings settings;
    settings.widest_bead = widest;
    std::vector<Path> planned = {line({1.0, 3.0}, {9.0, 3.0})};
    planned[0].points.insert(planned[0].points.begin() + 1, {{4.2, 3.0, 0.2}, {5.8, 3.0, 0.2}});
    const LiftedLayer lifted = liftOnto({pinched()}, {0.2, 0.2, planned}, settings, {}, 1.0);
    const Path& path = lifted.layer.paths.at(0);
    for (std::size_t i = 1; i < path.points.size(); ++i)
      EXPECT_LE(planWidth(path.bead.at(i)), widest * planWidth({0.4, 0.2}) * (1.0 + 1e-6));
    EXPECT_GT(lifted.left_out_mm3, 0.0);
    EXPECT_NEAR(depositedVolume(path) + lifted.left_out_mm3, depositedVolume(planned[0]), 1e-9);
  }
}

TEST(ChartLift, TravelsAcrossRunsThatItLeavesOut) {
  const Path first = line({1.0, 1.0}, {1.0, 9.0});
  const Path lost = line({5.0, 9.0}, {5.2, 9.0});
  const Path last = line({5.2, 9.0}, {9.0, 9.0});
  std::vector<Path> planned = withTravel(first, lost, false);
  planned.push_back(last);
  const LiftedLayer lifted = liftOnto({pinched()}, {0.2, 0.2, planned}, {}, {}, 1.0);
  ASSERT_EQ(lifted.layer.paths.size(), 3U);
  EXPECT_EQ(lifted.layer.paths[1].role, PathRole::Travel);
  EXPECT_NO_THROW(validate({"pinched", {lifted.layer}}));
  EXPECT_NEAR(volumeOf(lifted.layer.paths) + lifted.left_out_mm3, volumeOf(planned), 1e-9);
}

TEST(ChartLift, DrawsRunsToTheBorderThatLeaveTheirChartByItsSimplification) {
  const LayerChart chart = levelChart(10.0, 5);
  const Path path = lift(chart, {line({0.0, 10.009}, {10.0, 9.0})}).front();
  for (const Point3& point : path.points) EXPECT_LE(point.y(), 10.0 + 1e-12);
  EXPECT_NEAR(path.points.back().y(), 9.0, 1e-12);
  EXPECT_NO_THROW(lift(chart, {line({1.0, 10.009}, {9.0, 10.009})}));
  EXPECT_THROW(lift(chart, {line({1.0, 10.051}, {9.0, 10.051})}), InvalidInput);
}

TEST(ChartLift, LeavesOutTheLittleOfARunThatLiesBesideItsChart) {
  Path planned = line({1.0, 5.0}, {9.9, 5.0});
  const double z = planned.points.front().z();
  planned.points.insert(planned.points.end(), {{10.3, 5.2, z}, {9.9, 5.4, z}, {1.0, 5.4, z}});
  const std::vector<LayerChart> charts = {levelChart(10.0, 5)};
  const LiftedLayer lifted = liftOnto(charts, {0.2, 0.2, {planned}}, {}, {}, 1.0);
  ASSERT_EQ(lifted.layer.paths.size(), 3U);
  EXPECT_EQ(lifted.layer.paths[1].role, PathRole::Travel);
  EXPECT_NEAR(lifted.layer.paths[0].lastPoint().x(), 9.9, 1e-12);
  EXPECT_NEAR(lifted.layer.paths[2].firstPoint().y(), 5.4, 1e-12);
  EXPECT_NO_THROW(validate({"beside", {lifted.layer}}));
  EXPECT_NEAR(volumeOf(lifted.layer.paths) + lifted.left_out_mm3, volumeOf({planned}), 1e-9);
}

TEST(ChartLift, RefusesRunsThatLeaveTheirChart) {
  const LayerChart chart = levelChart(10.0, 5);
  EXPECT_THROW(lift(chart, {line({5, 5}, {11, 5})}), InvalidInput);
  const std::vector<LayerChart> apart = {chart, test::moved(chart, {12.0, 0.0})};
  EXPECT_THROW(liftOnto(apart, {0.2, 0.2, {line({5, 5}, {15, 5})}}, {}, {}, 1.0), InvalidInput);
}

TEST(NozzleFrame, OfTheVerticalIsExactlyThatOfTheUprightNozzle) {
  EXPECT_EQ(nozzleAgainst(Point3::UnitZ()).coeffs(), nozzleDown().coeffs());
}

TEST(NozzleFrame, PutsTheToolAxisAgainstAnyNormalAndKeepsTheNozzleFromSpinning) {
  EXPECT_TRUE(rc::check([] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Point3 normal =
        Point3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.9, 1)).normalized();
    const Eigen::Quaterniond nozzle = nozzleAgainst(normal);
    RC_ASSERT((againstToolAxis(nozzle) - normal).norm() <= 1e-12);
    // The turn from the upright nozzle has no part about the vertical.
    const Eigen::Quaterniond turn = nozzle * nozzleDown().conjugate();
    RC_ASSERT(std::abs(turn.z()) <= 1e-12);
  }));
}

}  // namespace
}  // namespace lamina
