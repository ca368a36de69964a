// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/layer_charts.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/parameterization/chart_outline.hpp"
#include "lamina/parameterization/distortion.hpp"
#include "lamina/parameterization/surface_cut.hpp"
#include "support/surfaces.hpp"

namespace lamina {
namespace {

using namespace test;

double areaOf(const std::vector<LayerChart>& charts) {
  double area = 0.0;
  for (const LayerChart& chart : charts) area += surfaceArea(chart.surface.middle);
  return area;
}

double planAreaOf(const std::vector<LayerChart>& charts) {
  double area = 0.0;
  for (const LayerChart& chart : charts) area += signedArea(outlineOf(chart));
  return area;
}

/// What every chart promises.
bool keepPromises(const std::vector<LayerChart>& charts, double tolerance) {
  for (const LayerChart& chart : charts) {
    const Distortion distortion = measureDistortion(chart.surface.middle, chart.parameterization);
    if (distortion.flipped > 0 || !isInjective(chart.surface.middle, chart.parameterization)) return false;
    if (distortion.least_stretch < 1.0 - tolerance || distortion.greatest_stretch > 1.0 + tolerance)
      return false;
  }
  return true;
}

bool areApart(const std::vector<LayerChart>& charts) {
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Box2 a = boundingBox(std::vector<Polygon>{charts[i].parameterization});
      const Box2 b = boundingBox(std::vector<Polygon>{charts[j].parameterization});
      if ((a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all()) return false;
    }
  return true;
}

/// Where the parameterization has the vertex nearest to a place.
Point2 layerChartsPlanAt(const LayerChart& chart, const Point3& place) {
  std::size_t nearest = 0;
  const std::vector<Point3>& vertices = chart.surface.middle.vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if ((vertices[i] - place).norm() < (vertices[nearest] - place).norm()) nearest = i;
  return chart.parameterization[nearest];
}

/// In the parameterization, from where one place lies to where another one does.
Point2 between(const LayerChart& chart, const Point3& from, const Point3& to) {
  return layerChartsPlanAt(chart, to) - layerChartsPlanAt(chart, from);
}

TEST(LayerCharts, ALevelLayerIsItsOwnParameterization) {
  const LayerSurface layer =
      layerOf(patch(7, 5, [](double u, double v) { return Point3(7.0 * u + 3.0, 5.0 * v, 2.0); }));
  const std::vector<LayerChart> charts = layerCharts(layer, {});
  ASSERT_EQ(charts.size(), 1U);
  ASSERT_EQ(charts[0].parameterization.size(), 48U);
  for (std::size_t i = 0; i < 48; ++i)
    EXPECT_LT((charts[0].parameterization[i] - charts[0].surface.middle.vertices[i].head<2>()).norm(), 1e-12);
}

TEST(LayerCharts, AnInclinedPlaneKeepsItsShapeAndDirection) {
  const LayerSurface layer =
      layerOf(patch(7, 5, [](double u, double v) { return Point3(8.0 * u, 5.0 * v, 6.0 * u); }));
  const std::vector<LayerChart> charts = layerCharts(layer, {});
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_LT((between(charts[0], {0.0, 0.0, 0.0}, {8.0, 0.0, 6.0}) - Point2(10.0, 0.0)).norm(), 1e-3);
  EXPECT_LT((between(charts[0], {0.0, 0.0, 0.0}, {0.0, 5.0, 0.0}) - Point2(0.0, 5.0)).norm(), 1e-3);
  EXPECT_NEAR(between(charts[0], {0.0, 0.0, 0.0}, {8.0, 5.0, 6.0}).norm(), std::sqrt(125.0), 1e-9);
}

TEST(LayerCharts, AHalfCylinderStaysWholeAndInPlace) {
  const LayerSurface layer = layerOf(halfCylinderMesh(40, 20, 10.0, 30.0));
  const std::vector<LayerChart> charts = layerCharts(layer, {});
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_TRUE(keepPromises(charts, 0.01));
  const Box2 box = boundingBox(std::vector<Polygon>{charts[0].parameterization});
  EXPECT_NEAR(box.low.x(), -5.0 * M_PI, 0.05);
  EXPECT_NEAR(box.high.x(), 5.0 * M_PI, 0.05);
  EXPECT_NEAR(box.low.y(), 0.0, 0.05);
  EXPECT_NEAR(box.high.y(), 30.0, 0.05);
}

TEST(LayerCharts, AVerticalWallStandsUpright) {
  // In the plane y = 0, seen from -y: its parameterization keeps x.
  const LayerSurface layer =
      layerOf(patch(10, 4, [](double u, double v) { return Point3(10.0 * u, 0.0, 4.0 * v); }));
  const std::vector<LayerChart> charts = layerCharts(layer, {});
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_NEAR(between(charts[0], {0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}).x(), 10.0, 1e-9);
  EXPECT_NEAR(between(charts[0], {0.0, 0.0, 0.0}, {0.0, 0.0, 4.0}).y(), 4.0, 1e-9);
}

TEST(LayerCharts, ALayerSeenFromBelowRunsAlongX) {
  const LayerSurface layer =
      layerOf(patch(6, 6, [](double u, double v) { return Point3(6.0 * u, -6.0 * v, 0.0); }));
  const std::vector<LayerChart> charts = layerCharts(layer, {});
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_NEAR(between(charts[0], {0.0, 0.0, 0.0}, {6.0, 0.0, 0.0}).x(), 6.0, 1e-9);
  EXPECT_NEAR(between(charts[0], {0.0, 0.0, 0.0}, {0.0, -6.0, 0.0}).y(), 6.0, 1e-9);
}

TEST(LayerCharts, LevelIslandsStayInTheirHoles) {
  LayerSurface layer = layerOf(plateMesh(10, 10, 10.0, 10.0));
  std::vector<double> field;
  for (const Point3& vertex : layer.middle.vertices)
    field.push_back(std::abs((vertex - Point3(5.0, 5.0, 0.0)).head<2>().norm() - 3.0) - 1.2);
  const std::vector<LayerChart> charts = layerCharts(whereNotNegative(layer, field), {});
  ASSERT_EQ(charts.size(), 2U);
  for (const LayerChart& chart : charts)
    for (std::size_t i = 0; i < chart.parameterization.size(); ++i)
      EXPECT_LT((chart.parameterization[i] - chart.surface.middle.vertices[i].head<2>()).norm(), 1e-9);
}

TEST(LayerCharts, ATubeIsCutIntoHalvesThatUnroll) {
  const LayerSurface layer = layerOf(band(60, 20, [](double u, double v) {
    return Point3(10.0 * std::cos(2.0 * M_PI * u), 10.0 * std::sin(2.0 * M_PI * u), 40.0 * v);
  }));
  const std::vector<LayerChart> charts = layerCharts(layer, {});
  EXPECT_EQ(charts.size(), 2U);
  EXPECT_TRUE(keepPromises(charts, 0.01));
  EXPECT_TRUE(areApart(charts));
  EXPECT_NEAR(areaOf(charts), surfaceArea(layer.middle), 1e-6);
}

TEST(LayerCharts, ACupIsCutIntoItsFloorAndTheHalvesOfItsWall) {
  for (const double floor : {0.1, 1.0, 5.0, 9.0}) {
    // Twice as steep as wide, with an odd number of facets.
    const LayerSurface layer = layerOf(disc(91, 20, [&](double share, double angle) {
      const double rise = std::max(0.0, 20.0 * share - 10.0);
      const double r = std::min(2.0 * share, 1.0) * floor + 0.5 * rise;
      return Point3(r * std::cos(angle), r * std::sin(angle), rise);
    }));
    const std::vector<LayerChart> charts = layerCharts(layer, {});
    EXPECT_EQ(charts.size(), 3U) << floor;
    EXPECT_TRUE(keepPromises(charts, 1e-3)) << floor;
    EXPECT_TRUE(areApart(charts));
    EXPECT_NEAR(areaOf(charts), surfaceArea(layer.middle), 1e-9);
  }
}

TEST(LayerCharts, ATruncatedOctahedronIsCutAlongItsEdges) {
  const Mesh solid = makePart("tetradecahedron");
  const Box3 box = boundingBox(solid);
  // Without its lid, and with it.
  LayerSurface cup = layerOf(solid);
  std::vector<double> field;
  for (const Point3& vertex : solid.vertices) field.push_back(box.centre().z() - vertex.z());
  cup = whereNotNegative(cup, field);
  for (const LayerSurface& layer : {cup, layerOf(solid)}) {
    const std::vector<LayerChart> charts = layerCharts(layer, {});
    EXPECT_LE(charts.size(), 5U);
    EXPECT_TRUE(keepPromises(charts, 1e-6));
    // No triangle was cut.
    std::size_t triangles = 0;
    for (const LayerChart& chart : charts) triangles += chart.surface.middle.triangles.size();
    EXPECT_EQ(triangles, layer.middle.triangles.size());
  }
}

TEST(LayerCharts, AFunnelOfFacetsIsCutAlongItsEdges) {
  // Four sides that lean by 45 degrees: curved nowhere, but it does not lie flat as a ring.
  const LayerSurface layer = layerOf(band(4, 6, [](double u, double v) {
    const double r = 5.0 + 5.0 * v;
    return Point3(r * std::cos(2.0 * M_PI * u), r * std::sin(2.0 * M_PI * u), 5.0 * std::sqrt(0.5) * v);
  }));
  const std::vector<LayerChart> charts = layerCharts(layer, {});
  EXPECT_EQ(charts.size(), 2U);
  EXPECT_TRUE(keepPromises(charts, 1e-6));
  for (const LayerChart& chart : charts) EXPECT_EQ(chart.surface.middle.triangles.size(), 24U);
}

TEST(LayerCharts, AConeIsCutThroughItsApex) {
  const std::vector<LayerChart> charts = layerCharts(layerOf(coneMesh(60, 20, 15.0)), {});
  EXPECT_EQ(charts.size(), 2U);
  EXPECT_TRUE(keepPromises(charts, 0.01));
}

TEST(LayerCharts, AHemisphereIsCutUntilItsLengthsAreTrue) {
  FlatteningSettings settings;
  const LayerSurface layer = layerOf(capMesh(60, 20, 20.0, 0.5 * M_PI));
  for (const double tolerance : {0.3, 0.15, 0.05, 0.02}) {
    settings.tolerance = tolerance;
    const std::vector<LayerChart> charts = layerCharts(layer, settings);
    EXPECT_TRUE(keepPromises(charts, tolerance));
    EXPECT_TRUE(areApart(charts));
    EXPECT_NEAR(areaOf(charts), surfaceArea(layer.middle), 1e-6);
    EXPECT_NEAR(planAreaOf(charts), surfaceArea(layer.middle), tolerance * surfaceArea(layer.middle));
  }
}

TEST(LayerCharts, HalvesShareTheirBorderExactly) {
  const LayerSurface layer = layerOf(capMesh(60, 20, 20.0, 0.5 * M_PI));
  using Place = std::tuple<double, double, double>;
  std::multiset<Place> places;
  const std::vector<LayerChart> charts = layerCharts(layer, {});
  for (const LayerChart& chart : charts)
    for (const Point3& vertex : chart.surface.middle.vertices)
      places.insert({vertex.x(), vertex.y(), vertex.z()});
  EXPECT_GT(charts.size(), 1U);
  for (const LayerChart& chart : charts) {
    LayerChart in_space = chart;
    for (std::size_t i = 0; i < chart.parameterization.size(); ++i)
      in_space.parameterization[i] = {static_cast<double>(i), 0.0};
    for (const Polygon& border : outlineOf(in_space))
      for (const Point2& number : border) {
        const Point3& vertex = chart.surface.middle.vertices[static_cast<std::size_t>(number.x())];
        if (vertex.z() > 1e-9) {
          EXPECT_GT(places.count({vertex.x(), vertex.y(), vertex.z()}), 1U);
        }
      }
  }
}

TEST(LayerCharts, AClosedSurfaceIsCutFirst) {
  const LayerSurface layer = layerOf(makePart("sphere", {{"radius_mm", "7"}}));
  const std::vector<LayerChart> charts = layerCharts(layer, {});
  EXPECT_GT(charts.size(), 1U);
  EXPECT_TRUE(keepPromises(charts, 0.15));
  EXPECT_NEAR(areaOf(charts), surfaceArea(layer.middle), 1e-6);
}

TEST(LayerCharts, RandomSmoothPatchesKeepTheirPromises) {
  EXPECT_TRUE(rc::check([] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    double wave[6];
    for (double& one : wave) one = random.uniform(-4.0, 4.0);
    const LayerSurface layer = layerOf(patch(16, 12, [&](double u, double v) {
      const double z =
          wave[0] * std::sin(wave[1] * u + wave[2] * v) + wave[3] * std::cos(wave[4] * v - wave[5] * u);
      return Point3(24.0 * u, 18.0 * v, z);
    }));
    const std::vector<LayerChart> charts = layerCharts(layer, {});
    RC_ASSERT(keepPromises(charts, 0.15));
    RC_ASSERT(areApart(charts));
    RC_ASSERT(std::abs(areaOf(charts) / surfaceArea(layer.middle) - 1.0) < 1e-9);
    RC_ASSERT(std::abs(planAreaOf(charts) / surfaceArea(layer.middle) - 1.0) < 0.15);
  }));
}

TEST(LayerCharts, SliversAlongABorderCutNothing) {
  EXPECT_TRUE(rc::check([] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    LayerSurface layer = layerOf(patch(40, 40, [](double u, double v) {
      return Point3(60.0 * u, 60.0 * v, 5.0 * std::sin(7.0 * u) * std::cos(5.0 * v));
    }));
    // Past a row of vertices, 1e-9 to 0.01 mm away, and across the rest.
    const double past = std::pow(10.0, -random.uniform(2.0, 9.0));
    const double heading = random.uniform(0.0, 2.0 * M_PI);
    std::vector<double> field;
    for (const Point3& vertex : layer.middle.vertices) field.push_back(vertex.x() - 18.0 - past);
    layer = whereNotNegative(layer, field);
    field.clear();
    for (const Point3& vertex : layer.middle.vertices)
      field.push_back(15.0 + (vertex.x() - 35.0) * std::cos(heading) +
                      (vertex.y() - 30.0) * std::sin(heading));
    layer = whereNotNegative(layer, field);
    const std::vector<LayerChart> charts = layerCharts(layer, {});
    RC_ASSERT(keepPromises(charts, 0.15));
    RC_ASSERT(charts.size() <= 2U);
  }));
}

TEST(LayerCharts, FoldsTooSmallForABeadAreLeftOut) {
  // Thrice around, like a spring, in a piece much smaller than a bead, by a method that bends nothing open.
  FlatteningSettings settings;
  settings.method = FlatteningMethod::Mds;
  settings.landmarks = 4;
  LayerSurface layer = layerOf(patch(120, 2, [](double u, double v) {
    const double r = 0.05 - 0.01 * v;
    return Point3(100.0 + r * std::cos(6.0 * M_PI * u), r * std::sin(6.0 * M_PI * u), 0.01 * u);
  }));
  layer.height_mm.assign(layer.height_mm.size(), 2.0);
  EXPECT_TRUE(layerCharts(layer, settings).empty());
}

/// Remembers what is reported; cancels once it has heard enough.
class ChartsHeard final : public Progress {
 public:
  explicit ChartsHeard(std::size_t enough) : enough_(enough) {}
  void report(const std::string&, double fraction) override { fractions.push_back(fraction); }
  bool isCancelled() const override { return fractions.size() >= enough_; }

  std::vector<double> fractions;

 private:
  std::size_t enough_;
};

TEST(LayerCharts, SayHowMuchOfTheAreaIsDone) {
  // A closed surface lies flat in no less than two pieces.
  ChartsHeard heard(1000);
  const std::vector<LayerChart> charts = layerCharts(layerOf(makePart("sphere")), {}, heard);
  ASSERT_GE(heard.fractions.size(), charts.size());
  EXPECT_TRUE(std::is_sorted(heard.fractions.begin(), heard.fractions.end()));
  EXPECT_GT(heard.fractions.front(), 0.0);
  EXPECT_LT(heard.fractions.front(), 1.0);
  EXPECT_NEAR(heard.fractions.back(), 1.0, 1e-6);
}

TEST(LayerCharts, StopBetweenThePiecesOfOneLayer) {
  ChartsHeard heard(1);
  EXPECT_THROW(layerCharts(layerOf(makePart("sphere")), {}, heard), Cancelled);
  EXPECT_EQ(heard.fractions.size(), 1U);
}

TEST(LayerCharts, AnEmptyLayerHasNone) { EXPECT_TRUE(layerCharts({}, {}).empty()); }

}  // namespace
}  // namespace lamina
