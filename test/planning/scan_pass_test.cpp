// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/scan_pass.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/scan_height.hpp"

namespace lamina {
namespace {

const ScanSight kOffset{{25.0, 0.0}, {0.0, 0.0}};

Path bead(const Point3& start, const Point3& end) {
  Path path;
  path.role = PathRole::Infill;
  path.points = {start, end};
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 50.0;
  return path;
}

Path travel(const Point3& start, const Point3& end) {
  Path path;
  path.role = PathRole::Travel;
  path.points = {start, end};
  path.feed_mm_s = 150.0;
  return path;
}

/// Layers of one line each, from `low` to `high`, joined by travels.
Toolpath diagonals(int layers, const Point2& low, const Point2& high) {
  Toolpath toolpath;
  for (int i = 0; i < layers; ++i) {
    ToolpathLayer layer;
    layer.height_mm = 0.2;
    layer.z_mm = 0.2 * (i + 1);
    const Point3 start(low.x(), low.y(), layer.z_mm);
    if (i > 0) layer.paths.push_back(travel(toolpath.layers.back().paths.back().lastPoint(), start));
    layer.paths.push_back(bead(start, {high.x(), high.y(), layer.z_mm}));
    toolpath.layers.push_back(layer);
  }
  validate(toolpath);
  return toolpath;
}

ScanSettings every(int layers) {
  ScanSettings settings;
  settings.every_layers = layers;
  return settings;
}

TEST(ScanPass, ZeroScansNothing) {
  const Toolpath toolpath = diagonals(3, {0, 0}, {10, 10});
  EXPECT_EQ(toolpathId(withScanPasses(toolpath, every(0), kOffset)), toolpathId(toolpath));
}

TEST(ScanPass, FollowsEachNthLayerAndTheLast) {
  const Toolpath scanned = withScanPasses(diagonals(8, {0, 0}, {10, 10}), every(3), kOffset);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(isScanned(scanned.layers[i], 1.0), i == 2 || i == 5 || i == 7) << "layer " << i;
  EXPECT_NO_THROW(validate(scanned));
}

TEST(ScanPass, IsKnownInLayersThatAreTurned) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.25 * M_PI, Point3::UnitX()));
  const Toolpath scanned = turned(withScanPasses(diagonals(3, {0, 0}, {10, 10}), every(2), kOffset), turn);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(isScanned(scanned.layers[i], 1.0, layerNormal(scanned)), i > 0) << "layer " << i;
    EXPECT_FALSE(isScanned(scanned.layers[i], 1.0)) << "layer " << i;
  }
}

TEST(ScanPass, IsRetractedAndDepositsNothing) {
  const Toolpath plain = diagonals(2, {0, 0}, {10, 10});
  const Toolpath scanned = withScanPasses(plain, every(1), kOffset);
  EXPECT_DOUBLE_EQ(totals(scanned).deposited_mm3, totals(plain).deposited_mm3);
  const Path& scan = scanned.layers[0].paths.back();
  EXPECT_TRUE(scan.process.is_retracted);
  EXPECT_EQ(scan.role, PathRole::Travel);
  EXPECT_EQ(scan.lastPoint(), scanned.layers[1].paths.front().firstPoint());
  EXPECT_EQ(scanned.layers[1].paths.front().role, PathRole::Infill) << "the old travel is replaced";
}

TEST(ScanPass, JoinsALayerThatStartsWithoutATravel) {
  Toolpath toolpath = diagonals(1, {0, 0}, {10, 10});
  ToolpathLayer second = toolpath.layers[0];
  second.z_mm = 0.4;
  second.paths = {bead({10, 10, 0.2}, {0, 0, 0.4})};
  toolpath.layers.push_back(second);
  const Toolpath scanned = withScanPasses(toolpath, every(1), kOffset);
  EXPECT_NO_THROW(validate(scanned));
  for (const ToolpathLayer& layer : scanned.layers) EXPECT_TRUE(isScanned(layer, 1.0)) << layer.z_mm;
  EXPECT_EQ(scanned.layers[0].paths.back().lastPoint(), Point3(10.0, 10.0, 0.2));
  EXPECT_EQ(scanned.layers[1].paths.front().role, PathRole::Infill);
}

TEST(ScanPass, EmptyLayersAreSkipped) {
  Toolpath toolpath = diagonals(3, {0, 0}, {10, 10});
  toolpath.layers[2].paths.clear();
  const Toolpath scanned = withScanPasses(toolpath, every(3), kOffset);
  EXPECT_TRUE(isScanned(scanned.layers[1], 1.0));
  EXPECT_TRUE(scanned.layers[2].paths.empty());
}

TEST(ScanPass, RefusesASensorWithoutALine) {
  ScanSettings without_line = every(1);
  without_line.swath_mm = 0.0;
  EXPECT_THROW(withScanPasses(diagonals(1, {0, 0}, {1, 1}), without_line, kOffset), InvalidConfig);
}

TEST(ScanPass, FliesHalfALayerOffAllPrintingHeights) {
  ToolpathLayer layer;
  layer.z_mm = 3.0;
  layer.height_mm = 0.2;
  EXPECT_NEAR(scanHeight(layer, 1.0), 4.1, 1e-12);
  EXPECT_NEAR(scanHeight(layer, 1.1), 4.1, 1e-12);
  EXPECT_NEAR(scanHeight(layer, 1.11), 4.3, 1e-12);
}

struct Sensor {
  ScanSight sight;
  double swath_mm;
};

/// Whether the sensor's line passes over the point during the layer's scan, where it lies at a height.
bool isSeen(const ToolpathLayer& layer, const Sensor& sensor, const Point3& point) {
  const Path& scan = layer.paths.back();
  const double z = scanHeight(layer, 1.0);
  const Point2 line = sensor.sight.offset_mm + (z - point.z()) * sensor.sight.lean;
  for (std::size_t i = 1; i < scan.points.size(); ++i) {
    const Point3 &a = scan.points[i - 1], &b = scan.points[i];
    if (std::abs(a.z() - z) > 1e-9 || std::abs(b.z() - z) > 1e-9) continue;
    const double from = std::min(a.y(), b.y()) + line.y();
    const double to = std::max(a.y(), b.y()) + line.y();
    const bool is_along_y = std::abs(a.x() - b.x()) < 1e-9;
    const bool is_across = std::abs(a.x() + line.x() - point.x()) <= 0.5 * sensor.swath_mm;
    if (is_along_y && is_across && from <= point.y() && point.y() <= to) return true;
  }
  return false;
}

TEST(ScanPass, TheLinePassesOverTheWholeBox) {
  EXPECT_TRUE(rc::check("for any box, sensor and swath", [](std::uint64_t seed) {
    Random random(seed);
    const Point2 low(random.uniform(-50, 50), random.uniform(-50, 50));
    const Point2 high = low + Point2(random.uniform(0.1, 120), random.uniform(0.1, 120));
    const Point2 lean(random.uniform(-1, 1), random.uniform(-2, 2));
    const Sensor sensor{{{random.uniform(-60, 60), random.uniform(-60, 60)}, lean}, random.uniform(2, 80)};
    ScanSettings settings = every(1);
    settings.swath_mm = sensor.swath_mm;
    const Toolpath scanned = withScanPasses(diagonals(2, low, high), settings, sensor.sight);
    validate(scanned);
    for (int i = 0; i < 20; ++i) {
      const double off = random.uniform(-0.2, 0.2);  // a layer at most
      const Point3 point(random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()), 0.2 + off);
      RC_ASSERT(isSeen(scanned.layers[0], sensor, point));
      RC_ASSERT(isSeen(scanned.layers[1], sensor, point + Point3(0, 0, 0.2)));
    }
  }));
}

/// A sensor at 45 deg over the layers, 1.1 mm above them, sees 1.1 mm farther on than below the nozzle.
TEST(ScanPass, OfASensorThatLeansPassesOverWhereTheLayerLies) {
  ScanSettings settings = every(1);
  settings.margin_mm = 1.0;
  const Toolpath scanned = withScanPasses(diagonals(1, {0, 0}, {10, 10}), settings, {{25, 0}, {0, -1}});
  const Path& scan = scanned.layers[0].paths.back();
  ASSERT_EQ(scan.points.size(), 4U);
  // Half a bead of 0.4 mm, the margin, and a layer of 0.2 mm on both sides.
  EXPECT_TRUE(scan.points[2].isApprox(Point3(5.0 - 25.0, 0.0 - 1.4 + 1.1, 1.3), 1e-9));
  EXPECT_TRUE(scan.points[3].isApprox(Point3(5.0 - 25.0, 10.0 + 1.4 + 1.1, 1.3), 1e-9));
}

}  // namespace
}  // namespace lamina
