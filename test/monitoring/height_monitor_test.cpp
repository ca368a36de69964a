// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/height_monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/toolpath/layer_frame.hpp"
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
  const auto reports = monitor.finish();
  EXPECT_EQ(reports.size(), 1u);
  return reports.at(0).statistics;
}

TEST(HeightMonitor, AFlatPlateShowsItsOffset) {
  const HeightStatistics statistics = statisticsOf([](const Point2&) { return 0.2 + 0.037; });
  EXPECT_NEAR(statistics.mean_mm, 0.037, 1e-12);
  EXPECT_NEAR(statistics.rms_mm, 0.037, 1e-12);
  EXPECT_NEAR(statistics.worst_mm, 0.037, 1e-12);
  EXPECT_DOUBLE_EQ(statistics.coverage, 1.0);
}

TEST(HeightMonitor, AnInclinedPlateShowsItsOffsetAlongItsNormal) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.25 * M_PI, Point3::UnitX()));
  const Eigen::Isometry3d bed_from_part(Eigen::Translation3d(30, -4, 11));
  HeightMonitor monitor(turned(scannedPlates({kPlate}), turn), bed_from_part, {});
  const auto onBed = [&](const Point3& in_layers) { return Point3(bed_from_part * (turn * in_layers)); };
  EXPECT_NEAR(monitor.heightOf(onBed({3, 4, 1.3})), 1.3, 1e-12);
  EXPECT_TRUE((monitor.bedFromHeights() * Point3(3, 4, 1.3)).isApprox(onBed({3, 4, 1.3}), 1e-12));
  for (double y = 4.05; y < 16.0; y += 0.1) {
    std::vector<Point3> profile;
    for (double x = 4.05; x < 26.0; x += 0.1) profile.push_back(onBed({x, y, 0.2 + 0.037}));
    monitor.insert(profile, monitor.heightOf(onBed({0, y, 1.3})));
  }
  const auto reports = monitor.finish();
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_NEAR(reports[0].expected_height_mm, 0.2, 1e-12);
  EXPECT_NEAR(reports[0].statistics.mean_mm, 0.037, 1e-9);
  EXPECT_NEAR(reports[0].statistics.worst_mm, 0.037, 1e-9);
  EXPECT_DOUBLE_EQ(reports[0].statistics.coverage, 1.0);
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
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].layer, 0u);
  EXPECT_EQ(first[0].sight, LayerSight::Seen);
  EXPECT_EQ(first[0].profiles, 119u);  // 120 rows, the first of them as the nozzle arrives
  EXPECT_DOUBLE_EQ(first[0].expected_height_mm, 0.2);
  EXPECT_NEAR(first[0].statistics.mean_mm, 0.01, 1e-12);
  scan(
      monitor, [](const Point2&) { return 0.38; }, 1.5);
  const auto second = monitor.finish();
  ASSERT_EQ(second.size(), 1u);
  EXPECT_EQ(second[0].layer, 1u);
  EXPECT_NEAR(second[0].statistics.mean_mm, -0.02, 1e-12);
  EXPECT_NEAR(monitor.deviation().nearest({10.05, 10.05}), -0.02, 1e-12);
  EXPECT_TRUE(monitor.finish().empty());
}

TEST(HeightMonitor, AFinishedScanStaysFinished) {
  HeightMonitor monitor = onePlate();
  scan(monitor, [](const Point2&) { return 0.2; });
  EXPECT_GT(monitor.cellsInScan(), 0u);
  EXPECT_EQ(monitor.finish().size(), 1u);
  scan(monitor, [](const Point2&) { return 0.5; });
  EXPECT_EQ(monitor.cellsInScan(), 0u);
  EXPECT_TRUE(monitor.finish().empty());
}

TEST(HeightMonitor, FromOneScanStraightIntoTheNextBothAreReported) {
  HeightMonitor monitor(scannedPlates({kPlate, kPlate}), Eigen::Isometry3d::Identity(), {});
  scan(
      monitor, [](const Point2&) { return 0.2; }, 1.3);
  EXPECT_EQ(monitor.insert({{10, 10, 0.4}}, 1.5).at(0).layer, 0u);
  EXPECT_TRUE(monitor.insert({{10, 10, 0.4}}, 1.5).empty());
  EXPECT_EQ(monitor.finish().at(0).layer, 1u);
}

TEST(HeightMonitor, ALayerWhoseScanWasMissedIsReportedAsNotSeenWhenALaterOneIs) {
  HeightMonitor monitor(scannedPlates({kPlate, kPlate, kPlate, kPlate}), Eigen::Isometry3d::Identity(), {});
  scan(
      monitor, [](const Point2&) { return 0.2; }, 1.3);
  for (int i = 0; i < 3; ++i) monitor.move(0.8);  // the last layer is printed already
  monitor.move(1.9);
  EXPECT_TRUE(monitor.move(1.9).empty());
  const auto missed = monitor.add({{10, 10, 0.8}});
  ASSERT_EQ(missed.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(missed[i].layer, i + 1);
    EXPECT_EQ(missed[i].sight, LayerSight::NotSeen);
    EXPECT_EQ(missed[i].statistics.cells, 0u);
    EXPECT_EQ(missed[i].profiles, 0u);
  }
  const auto last = monitor.finish();
  ASSERT_EQ(last.size(), 1u);
  EXPECT_EQ(last[0].layer, 3u);
  EXPECT_EQ(last[0].sight, LayerSight::Seen);
}

TEST(HeightMonitor, AtTheEndLayersThatWerePrintedAndNotScannedAreReportedAsNotSeen) {
  HeightMonitor monitor(scannedPlates({kPlate, kPlate, kPlate, kPlate}), Eigen::Isometry3d::Identity(), {});
  for (int i = 0; i < 2; ++i) monitor.move(0.4);
  const auto missed = monitor.finish();
  ASSERT_EQ(missed.size(), 2u) << "of the layers above nobody knows anything yet";
  EXPECT_EQ(missed[0].layer, 0u);
  EXPECT_EQ(missed[1].layer, 1u);
  EXPECT_EQ(missed[1].sight, LayerSight::NotSeen);
  EXPECT_DOUBLE_EQ(missed[1].expected_height_mm, 0.4);
}

TEST(HeightMonitor, AScanThatShowsNothingOfItsLayerIsNotSeen) {
  HeightMonitor monitor = onePlate();
  scan(monitor, [](const Point2&) { return NAN; });
  const auto reports = monitor.finish();
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].sight, LayerSight::NotSeen);
  EXPECT_GT(reports[0].profiles, 100u);
}

TEST(HeightMonitor, AScanThatIsGivenUpIsReportedAsCutShort) {
  HeightMonitor monitor = onePlate();
  scan(monitor, [](const Point2&) { return 0.2; });
  const auto reports = monitor.closeScan(LayerSight::CutShort);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].sight, LayerSight::CutShort);
  EXPECT_TRUE(monitor.closeScan(LayerSight::CutShort).empty());
}

TEST(HeightMonitor, OtherProfilesEnterTheMapAlone) {
  HeightMonitor monitor = onePlate();
  scan(
      monitor, [](const Point2&) { return 0.3; }, 0.2);
  const auto reports = monitor.finish();
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].sight, LayerSight::NotSeen);
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
