// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/height_monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "support/scanned_plates.hpp"

namespace lamina {
namespace {

const Box2 kPlate{Point2(5, 5), Point2(25, 15)};
using Surface = std::function<double(const Point2&)>;

HeightMonitor onePlate() { return HeightMonitor(scannedPlates({kPlate}), Eigen::Isometry3d::Identity(), {}); }

/// Scans the area with one point per cell of 0.1 mm, a row a profile; holes in the surface are NaN.
void scan(HeightMonitor& monitor, const Surface& surface, double nozzle_height = 1.3) {
  for (double y = 4.05; y < 16.0; y += 0.1) {
    std::vector<Point3> profile;
    for (double x = 4.05; x < 26.0; x += 0.1) profile.emplace_back(x, y, surface({x, y}));
    monitor.insert(profile, nozzle_height);
  }
}

HeightStatistics statisticsOf(const Surface& surface) {
  HeightMonitor monitor = onePlate();
  scan(monitor, surface);
  const auto report = monitor.finish();
  EXPECT_TRUE(report.has_value());
  return report->statistics;
}

TEST(HeightMonitor, AFlatPlateShowsItsOffset) {
  const HeightStatistics statistics = statisticsOf([](const Point2&) { return 0.2 + 0.037; });
  EXPECT_NEAR(statistics.mean_mm, 0.037, 1e-12);
  EXPECT_NEAR(statistics.rms_mm, 0.037, 1e-12);
  EXPECT_NEAR(statistics.worst_mm, 0.037, 1e-12);
  EXPECT_DOUBLE_EQ(statistics.coverage, 1.0);
}

TEST(HeightMonitor, ATiltedPlateShowsItsSlope) {
  // About the middle of the plate the errors cancel; their mean square is slope² width² / 12.
  const HeightStatistics statistics =
      statisticsOf([](const Point2& p) { return 0.2 + 0.01 * (p.x() - 15.0); });
  const double width =
      19.6 + 0.2;  // of the flat tops: the centre lines, and half a flat top beyond either end
  EXPECT_NEAR(statistics.mean_mm, 0.0, 1e-3);
  EXPECT_NEAR(statistics.rms_mm, 0.01 * width / std::sqrt(12.0), 1e-3);
  EXPECT_NEAR(std::abs(statistics.worst_mm), 0.01 * 0.5 * width, 1.5e-3);
}

TEST(HeightMonitor, AMissingCornerShowsInTheWorstError) {
  const HeightStatistics statistics =
      statisticsOf([](const Point2& p) { return p.x() > 20 && p.y() > 10 ? 0.0 : 0.2; });
  EXPECT_NEAR(statistics.worst_mm, -0.2, 1e-12);
  EXPECT_NEAR(statistics.mean_mm, -0.2 * 0.25 * 0.5, 2e-3);
  EXPECT_DOUBLE_EQ(statistics.coverage, 1.0);
}

TEST(HeightMonitor, AnUnseenCornerShowsInTheCoverage) {
  const HeightStatistics statistics =
      statisticsOf([](const Point2& p) { return p.x() > 20 && p.y() > 10 ? NAN : 0.2; });
  EXPECT_NEAR(statistics.coverage, 1.0 - 0.25 * 0.5, 0.01);
  EXPECT_NEAR(statistics.worst_mm, 0.0, 1e-12);
}

TEST(HeightMonitor, NoiseStaysWithinThreeDeviationsOfTheMean) {
  Random random(11);
  const double sigma = 0.02;
  const HeightStatistics statistics =
      statisticsOf([&](const Point2&) { return 0.2 + random.normal(0.0, sigma); });
  EXPECT_LE(std::abs(statistics.mean_mm), 3.0 * sigma / std::sqrt(double(statistics.cells)));
  EXPECT_NEAR(statistics.rms_mm, sigma, 0.001);
}

TEST(HeightMonitor, ALayerIsFinalWhenTheNozzleLeavesItsScanHeight) {
  HeightMonitor monitor(scannedPlates({kPlate, kPlate}), Eigen::Isometry3d::Identity(), {});
  scan(
      monitor, [](const Point2&) { return 0.21; }, 1.3);
  const auto first = monitor.insert({{10, 10, 0.21}}, 0.4);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->layer, 0u);
  EXPECT_DOUBLE_EQ(first->expected_height_mm, 0.2);
  EXPECT_NEAR(first->statistics.mean_mm, 0.01, 1e-12);
  scan(
      monitor, [](const Point2&) { return 0.38; }, 1.5);
  const auto second = monitor.finish();
  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->layer, 1u);
  EXPECT_NEAR(second->statistics.mean_mm, -0.02, 1e-12);
  EXPECT_NEAR(monitor.deviation().nearest({10.05, 10.05}), -0.02, 1e-12);
  EXPECT_FALSE(monitor.finish().has_value());
}

TEST(HeightMonitor, AFinishedScanStaysFinished) {
  HeightMonitor monitor = onePlate();
  scan(monitor, [](const Point2&) { return 0.2; });
  EXPECT_GT(monitor.cellsInScan(), 0u);
  EXPECT_TRUE(monitor.finish().has_value());
  scan(monitor, [](const Point2&) { return 0.5; });
  EXPECT_EQ(monitor.cellsInScan(), 0u);
  EXPECT_FALSE(monitor.finish().has_value());
}

TEST(HeightMonitor, FromOneScanStraightIntoTheNextBothAreReported) {
  HeightMonitor monitor(scannedPlates({kPlate, kPlate}), Eigen::Isometry3d::Identity(), {});
  scan(
      monitor, [](const Point2&) { return 0.2; }, 1.3);
  EXPECT_EQ(monitor.insert({{10, 10, 0.4}}, 1.5)->layer, 0u);
  EXPECT_FALSE(monitor.insert({{10, 10, 0.4}}, 1.5).has_value());
  EXPECT_EQ(monitor.finish()->layer, 1u);
}

TEST(HeightMonitor, OtherProfilesEnterTheMapAlone) {
  HeightMonitor monitor = onePlate();
  scan(
      monitor, [](const Point2&) { return 0.3; }, 0.2);
  monitor.insert({{10.02, 10.02, 0.5}}, std::nullopt);
  EXPECT_FALSE(monitor.finish().has_value());
  EXPECT_EQ(monitor.profilesOfLayers(), 0u);
  EXPECT_GT(monitor.otherProfiles(), 100u);
  EXPECT_GT(heightRange(monitor.measured().heights()).known, 10000u);
}

TEST(HeightMonitor, PointsBeyondTheMapAreCounted) {
  HeightMonitor monitor = onePlate();
  monitor.insert({{10, 10, 0.2}, {1000, 10, 0.2}, {NAN, 0, 0}}, 1.3);
  EXPECT_EQ(monitor.pointsOutside(), 2u);
}

TEST(HeightMonitor, RefusesAToolpathThatDepositsNothing) {
  EXPECT_THROW(HeightMonitor({}, Eigen::Isometry3d::Identity(), {}), InvalidInput);
}

TEST(HeightMonitor, RefusesAPartTooLargeForTheCells) {
  const Toolpath large = scannedPlates({{{0, 0}, {2000, 2000}}});
  EXPECT_THROW(HeightMonitor(large, Eigen::Isometry3d::Identity(), {}), InvalidInput);
}

}  // namespace
}  // namespace lamina
