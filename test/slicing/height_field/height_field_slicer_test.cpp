// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/height_field/height_field_slicer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/solid_under.hpp"

namespace lamina {
namespace {

using test::solidUnder;

constexpr double kHeightFieldSlicerDegree = M_PI / 180.0;

HeightFieldSlices slice(const Mesh& mesh, const HeightFieldSettings& settings = {}) {
  NoProgress progress;
  return sliceByHeightField(mesh, {}, settings, progress);
}

Mesh roof(double angle_deg) {
  const double slope = std::tan(angle_deg * kHeightFieldSlicerDegree);
  return solidUnder({20.0, 12.0}, 1, 1, [&](double x, double) { return 8.0 + slope * x; });
}

/// A spherical dome of radius 20 mm on a block.
double domeHeight(double x, double y) {
  return 6.0 + std::sqrt(400.0 - std::pow(x - 12.0, 2) - std::pow(y - 12.0, 2)) - std::sqrt(400.0 - 288.0);
}

Mesh dome() { return solidUnder({24.0, 24.0}, 48, 48, domeHeight); }

/// Volume of the layers, by samples a quarter of a millimetre apart.
double volumeOf(const HeightFieldSlices& slices) {
  constexpr double kStep = 0.25;
  double sum = 0.0;
  for (const Layer& layer : slices.layers) {
    const Box2 box = boundingBox(layer.section.contours);
    if (box.isEmpty()) continue;
    for (double y = box.low.y() + 0.5 * kStep; y < box.high.y(); y += kStep)
      for (double x = box.low.x() + 0.5 * kStep; x < box.high.x(); x += kStep)
        if (contains(layer.section.contours, {x, y}))
          sum += kStep * kStep * layer.bounds.height() * slices.field.factorAt({x, y});
  }
  return sum;
}

TEST(HeightFieldSlicer, MakesTheTopLayerOfAnInclinedRoofLieOnIt) {
  const HeightFieldSlices slices = slice(roof(10.0));
  const Layer& last = slices.layers.back();
  const LayerChart chart = bentLayer(slices.field, last.bounds, boundingBox(last.section.contours));
  for (const Point3& tip : chart.surface.tip)
    if (tip.x() >= 0.0 && tip.x() <= 20.0) {
      EXPECT_NEAR(tip.z(), 8.0 + std::tan(10.0 * kHeightFieldSlicerDegree) * tip.x(), 1e-5);
    }
  EXPECT_NEAR(slices.report.bent_error_mm, 0.0, 1e-5);
  EXPECT_NEAR(slices.report.bent_steps_per_mm, 0.0, 1e-4);
  EXPECT_NEAR(slices.report.level_steps_per_mm, std::tan(10.0 * kHeightFieldSlicerDegree) / 0.2, 1e-6);
  // Level layers leave a saw tooth of 0.2 mm.
  EXPECT_NEAR(slices.report.level_error_mm, 0.05, 0.005);
  EXPECT_EQ(slices.report.share, 1.0);
  EXPECT_NEAR(slices.report.greatest_slope_deg, 10.0, 0.3);
  // The last layer covers the whole roof.
  EXPECT_NEAR(signedArea(last.section.contours), 240.0, 1e-3);
}

TEST(HeightFieldSlicer, MakesLayersThickerWhereTheRoofIsHigher) {
  const HeightFieldSlices slices = slice(roof(10.0));
  const double rise = 20.0 * std::tan(10.0 * kHeightFieldSlicerDegree);
  EXPECT_NEAR(slices.field.factorAt({20.0, 6.0}) / slices.field.factorAt({0.0, 6.0}), (8.0 + rise) / 8.0,
              1e-6);
}

TEST(HeightFieldSlicer, LeavesTheBedFlat) {
  const HeightFieldSlices slices = slice(dome());
  const LayerChart chart = bentLayer(slices.field, {0.0, 1e-6}, slices.field.cells.area());
  ASSERT_FALSE(chart.surface.tip.empty());
  for (const Point3& tip : chart.surface.tip) EXPECT_NEAR(tip.z(), 0.0, 2e-6);
}

TEST(HeightFieldSlicer, FollowsADomeAsFarAsItIsFlatEnough) {
  const HeightFieldSlices slices = slice(dome());
  EXPECT_LT(slices.report.bent_error_mm, 0.05 * slices.report.level_error_mm);
  EXPECT_LE(slices.report.greatest_slope_deg, 20.0 + 1e-9);
  // The cap of the sphere up to 20 deg, in the part's square.
  const double cap = M_PI * std::pow(20.0 * std::sin(20.0 * kHeightFieldSlicerDegree), 2);
  EXPECT_NEAR(slices.report.followed_mm2, cap, 0.1 * cap);
}

TEST(HeightFieldSlicer, HoldsTheVolumeOfThePart) {
  for (const Mesh& mesh : {roof(10.0), dome(), makePart("sphere", {{"radius_mm", "7"}})})
    EXPECT_NEAR(volumeOf(slice(mesh)) / volume(mesh), 1.0, 0.01);
}

TEST(HeightFieldSlicer, LeavesAFlatPartInLevelLayers) {
  const Mesh box = solidUnder({10.0, 10.0}, 1, 1, [](double, double) { return 5.0; });
  const HeightFieldSlices slices = slice(box);
  for (const double factor : slices.field.factor) EXPECT_NEAR(factor, 1.0, 1e-9);
  EXPECT_EQ(slices.layers.size(), 25U);
  for (const Layer& layer : slices.layers) EXPECT_NEAR(signedArea(layer.section.contours), 100.0, 1e-9);
}

TEST(HeightFieldSlicer, SaysWhenEverythingIsTooSteep) {
  const HeightFieldSlices slices = slice(roof(30.0));
  EXPECT_EQ(slices.report.followed_mm2, 0.0);
  for (const double factor : slices.field.factor) EXPECT_NEAR(factor, 1.0, 0.02);
  const std::vector<std::string> notes = notesOf(slices.report, {});
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("level"), std::string::npos);
}

TEST(HeightFieldSlicer, ScalesABendThatWouldMakeLayersTooThinAndReports) {
  HeightFieldSettings settings;
  settings.min_thickness = 0.9;
  settings.max_thickness = 1.1;
  const HeightFieldSlices slices = slice(roof(15.0), settings);
  EXPECT_GE(slices.report.least_thickness_mm, 0.9 * 0.2 - 1e-9);
  EXPECT_LE(slices.report.greatest_thickness_mm, 1.1 * 0.2 + 1e-9);
  EXPECT_GT(slices.report.greatest_thickness_mm - slices.report.least_thickness_mm, 0.01);
  EXPECT_GT(slices.report.followed_mm2, 0.0);
}

/// A few hills that need not be flat.
Mesh hills(Random& random) {
  const double a = random.uniform(0.0, 3.0);
  const double b = random.uniform(0.0, 3.0);
  const double p = random.uniform(0.1, 0.8);
  const double q = random.uniform(0.1, 0.8);
  const double step = random.uniform(0.0, 4.0);
  return solidUnder({18.0, 14.0}, 36, 28, [&](double x, double y) {
    return 7.0 + a * std::sin(p * x) + b * std::cos(q * y) + (x > 9.0 ? step : 0.0);
  });
}

TEST(HeightFieldSlicer, KeepsSlopeAndThicknessWithinTheirLimitsOnAnyPart) {
  EXPECT_TRUE(rc::check([] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    HeightFieldSettings settings;
    settings.max_slope_deg = random.uniform(3.0, 40.0);
    settings.min_thickness = random.uniform(0.5, 0.95);
    settings.max_thickness = random.uniform(1.05, 1.6);
    settings.cell_mm = random.uniform(0.7, 2.0);
    const Mesh part = hills(random);
    const HeightFieldSlices slices = slice(part, settings);
    const double steepest = std::tan(settings.max_slope_deg * kHeightFieldSlicerDegree) + 1e-9;
    for (std::size_t i = 0; i < slices.layers.size(); i += 5) {
      const Layer& layer = slices.layers[i];
      // Points of the layer: where it is thinner, thicker or steeper than allowed.
      for (int k = 0; k < 200; ++k) {
        const Point2 at(random.uniform(0.0, 18.0), random.uniform(0.0, 14.0));
        if (!contains(layer.section.contours, at)) continue;
        const double factor = slices.field.factorAt(at);
        RC_ASSERT(factor >= settings.min_thickness - 1e-9 && factor <= settings.max_thickness + 1e-9);
        constexpr double kStep = 1e-6;
        const double z = layer.bounds.cut();
        const Point2 slope(slices.field.factorAt(at + Point2(kStep, 0)) - factor,
                           slices.field.factorAt(at + Point2(0, kStep)) - factor);
        RC_ASSERT(z * slope.norm() / kStep <= steepest + 1e-6);
      }
    }
  }));
}

TEST(HeightFieldSlicer, IsRefusedWhereThereIsNothingToBend) {
  EXPECT_THROW(slice({}), InvalidMesh);
  EXPECT_THROW(slice({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}), InvalidMesh);
  HeightFieldSettings settings;
  settings.cell_mm = 0.0;
  EXPECT_THROW(slice(dome(), settings), InvalidConfig);
  settings.cell_mm = 0.05;
  EXPECT_THROW(slice(solidUnder({400, 400}, 1, 1, [](double, double) { return 9.0; }), settings),
               InvalidConfig);
}

}  // namespace
}  // namespace lamina
