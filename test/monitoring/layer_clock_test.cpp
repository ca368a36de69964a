// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/layer_clock.hpp"

#include <gtest/gtest.h>

#include "support/scanned_plates.hpp"

namespace lamina {
namespace {

// Layer k is printed at 0.2 (k + 1) and scanned 1.1 mm above that.
LayerClock tenLayers(std::size_t scanned_from = 0) {
  Toolpath toolpath = scannedPlates(std::vector<Box2>(10, Box2{Point2(5, 5), Point2(10, 10)}));
  for (std::size_t i = 0; i < scanned_from; ++i) toolpath.layers[i].paths.pop_back();
  return LayerClock(toolpath, Eigen::Isometry3d::Identity(), 1.0);
}

/// A nozzle that travels at that height, and a profile on the way.
std::optional<std::size_t> observeTwice(LayerClock& clock, double height) {
  clock.observe(height);
  const auto layer = clock.observe(height);
  clock.see();
  return layer;
}

TEST(LayerClock, ReportsTheLayerFromItsScanHeight) {
  LayerClock clock = tenLayers();
  EXPECT_EQ(clock.observe(0.2), std::nullopt);
  EXPECT_EQ(observeTwice(clock, 1.3), 0u);
  EXPECT_EQ(clock.observe(1.34), 0u);
  EXPECT_EQ(clock.observe(1.4), std::nullopt);
  EXPECT_EQ(observeTwice(clock, 1.5), 1u);
}

TEST(LayerClock, AHigherPartShiftsAllHeights) {
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  bed_from_part.translation().z() = 5.0;
  LayerClock clock(scannedPlates({{{5, 5}, {10, 10}}}), bed_from_part, 1.0);
  EXPECT_EQ(clock.observe(1.3), std::nullopt);
  EXPECT_EQ(observeTwice(clock, 6.3), 0u);
}

TEST(LayerClock, ALayerThatWasLeftIsDoneWith) {
  LayerClock clock = tenLayers();
  EXPECT_EQ(observeTwice(clock, 1.3), 0u);
  EXPECT_EQ(clock.observe(0.4), std::nullopt);
  EXPECT_EQ(clock.observe(1.3), std::nullopt);
}

TEST(LayerClock, AScanWithoutAProfileIsStillToCome) {
  LayerClock clock = tenLayers();
  clock.observe(1.3);
  EXPECT_EQ(clock.observe(1.3), 0u);
  EXPECT_EQ(clock.observe(0.4), std::nullopt);
  EXPECT_EQ(observeTwice(clock, 1.3), 0u);
}

TEST(LayerClock, ReportsWhichLayersAreScannedAndWhichWasPrinted) {
  LayerClock clock = tenLayers(7);
  EXPECT_EQ(clock.scannedLayers(), (std::vector<std::size_t>{7, 8, 9}));
  EXPECT_EQ(clock.printed(), std::nullopt);
  clock.observe(0.6);
  clock.observe(0.6);
  EXPECT_EQ(clock.printed(), 2u);
}

TEST(LayerClock, ANozzleOnItsWayDownScansNothing) {
  LayerClock clock = tenLayers();
  for (double z = 40.0; z > 0.0; z -= 0.05) EXPECT_EQ(clock.observe(z), std::nullopt) << z;
}

TEST(LayerClock, ANozzleThatRisesFromTheBedScansNothing) {
  LayerClock clock = tenLayers();
  for (double z = 0.0; z < 5.0; z += 0.01) EXPECT_EQ(clock.observe(z), std::nullopt) << z;
  EXPECT_EQ(observeTwice(clock, 1.3), 0u);
}

TEST(LayerClock, ANozzleParkedAtALaterScanHeightScansNothing) {
  LayerClock clock = tenLayers();
  for (int i = 0; i < 100; ++i) EXPECT_EQ(clock.observe(2.9), std::nullopt);
  EXPECT_EQ(observeTwice(clock, 1.3), 0u);
}

TEST(LayerClock, ALostScanDoesNotLoseTheLaterOnes) {
  LayerClock clock = tenLayers();
  EXPECT_EQ(observeTwice(clock, 1.3), 0u);
  for (int i = 0; i < 5; ++i) clock.observe(0.2 * 4);  // layer 3 is printed, the scans of 1 and 2 were lost
  EXPECT_EQ(observeTwice(clock, 0.2 * 4 + 1.1), 3u);
}

TEST(LayerClock, LayersWithoutAScanPassAreNeverScanned) {
  LayerClock clock = tenLayers(5);
  for (int i = 0; i < 5; ++i) clock.observe(0.4);
  EXPECT_EQ(clock.observe(1.5), std::nullopt);
  EXPECT_EQ(observeTwice(clock, 0.2 * 6 + 1.1), 5u);
}

}  // namespace
}  // namespace lamina
