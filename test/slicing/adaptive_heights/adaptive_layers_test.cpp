// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adaptive_heights/adaptive_layers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"

namespace lamina {
namespace {

SlicingSettings adaptive() {
  SlicingSettings settings;
  settings.heights = LayerHeights::Adaptive;
  return settings;
}

/// Of a body of revolution by its profile: radius and height of each ring.
Mesh revolved(const std::vector<Point2>& profile) {
  constexpr std::uint32_t kSides = 96;
  Mesh mesh;
  for (const Point2& ring : profile)
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double angle = 2.0 * M_PI * i / kSides;
      mesh.vertices.emplace_back(ring.x() * std::cos(angle), ring.x() * std::sin(angle), ring.y());
    }
  const auto rings = static_cast<std::uint32_t>(profile.size());
  for (std::uint32_t r = 0; r + 1 < rings; ++r)
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t a = r * kSides + i;
      const std::uint32_t b = r * kSides + (i + 1) % kSides;
      mesh.triangles.push_back({a, b, b + kSides});
      mesh.triangles.push_back({a, b + kSides, a + kSides});
    }
  const auto cap = [&](std::uint32_t ring, bool faces_up) {
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0, 0.0, profile[ring].y());
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t a = ring * kSides + i;
      const std::uint32_t b = ring * kSides + (i + 1) % kSides;
      mesh.triangles.push_back(faces_up ? Triangle{middle, a, b} : Triangle{middle, b, a});
    }
  };
  cap(0, false);
  cap(rings - 1, true);
  return mesh;
}

/// The upper half of a sphere.
Mesh hemisphere(double radius_mm, int rings = 400) {
  std::vector<Point2> profile;
  for (int i = 0; i <= rings; ++i) {
    const double angle = 0.5 * M_PI * std::min(0.9999, i / static_cast<double>(rings));
    profile.emplace_back(radius_mm * std::cos(angle), radius_mm * std::sin(angle));
  }
  profile.back().y() = radius_mm;
  return revolved(profile);
}

double layerHeightAt(const std::vector<LayerBounds>& bounds, double z_mm) {
  for (const LayerBounds& layer : bounds)
    if (z_mm > layer.bottom_mm && z_mm <= layer.top_mm) return layer.height();
  return 0.0;
}

bool endsAt(const std::vector<LayerBounds>& bounds, double z_mm) {
  return std::any_of(bounds.begin(), bounds.end(),
                     [&](const LayerBounds& layer) { return std::abs(layer.top_mm - z_mm) < 1e-9; });
}

constexpr double kFlat = 0.999;  // |n_z| from which a face of a part counts as level

/// The greatest h |n_z| of each layer and each face that it meets, but for those that count as level.
double steepestStep(const Mesh& mesh, const std::vector<LayerBounds>& bounds, double level = kFlat) {
  double greatest = 0.0;
  for (const Triangle& triangle : mesh.triangles) {
    const Point3& a = mesh.vertices[triangle[0]];
    const Point3& b = mesh.vertices[triangle[1]];
    const Point3& c = mesh.vertices[triangle[2]];
    const double lean = std::abs((b - a).cross(c - a).normalized().z());
    if (lean > level) continue;
    const auto [low, high] = std::minmax({a.z(), b.z(), c.z()});
    for (const LayerBounds& layer : bounds)
      if (layer.bottom_mm < high - 1e-9 && layer.top_mm > low + 1e-9)
        greatest = std::max(greatest, layer.height() * lean);
  }
  return greatest;
}

void expectStacked(const std::vector<LayerBounds>& bounds) {
  for (std::size_t i = 1; i < bounds.size(); ++i)
    EXPECT_DOUBLE_EQ(bounds[i].bottom_mm, bounds[i - 1].top_mm) << i;
}

TEST(AdaptiveLayers, OfADomeLeaveEqualCusps) {
  const Mesh mesh = hemisphere(20.0, 2000);
  SlicingSettings settings = adaptive();
  settings.first_layer_height_mm = 0.3;
  const AdaptiveLayers layers = adaptiveLayers(mesh, settings);
  expectStacked(layers.bounds);
  // h = c R / z between the bounds: (400 - 6.67²) / 4 + 6.67 / 0.3 = 111.1 layers.
  EXPECT_GE(layers.bounds.size(), 111U);
  EXPECT_LE(layers.bounds.size(), 113U);
  // At their upper ends, where faces are flattest: 0.3 mm up to 6.67, 0.2 at 10, 0.1 at 20 mm. To end at the
  // top with a whole number of layers all are lower by at most one part in as many.
  for (const LayerBounds& layer : layers.bounds) {
    const double wanted_mm = std::min(0.3, 0.1 * 20.0 / layer.top_mm);
    EXPECT_LE(layer.height(), 1.003 * wanted_mm) << layer.top_mm;
    EXPECT_GE(layer.height(), 0.997 * wanted_mm * 111.0 / 112.0) << layer.top_mm;
  }
  EXPECT_LE(steepestStep(mesh, layers.bounds), 0.1 + 1e-9);
  EXPECT_LE(steepestStep(mesh, layers.bounds, 1.0 - 1e-12), 1.003 * 0.1) << "all faces but the bottom";
  EXPECT_NEAR(layers.bounds.back().top_mm, 20.0, 1e-9);
}

TEST(AdaptiveLayers, TellTheGreatestCuspThatTheyLeave) {
  const Mesh mesh = hemisphere(20.0);
  const AdaptiveLayers layers = adaptiveLayers(mesh, adaptive());
  EXPECT_NEAR(greatestCusp(mesh, layers.bounds), steepestStep(mesh, layers.bounds), 1e-12);
}

TEST(AdaptiveLayers, OfADomeAreFewerThanEqualOnesOfTheSameCusp) {
  SlicingSettings equal;
  equal.layer_height_mm = equal.first_layer_height_mm = 0.1;
  const std::vector<LayerBounds> bounds = stackLayers(0.0, 20.0, equal);
  EXPECT_EQ(bounds.size(), 200U);
  EXPECT_NEAR(steepestStep(hemisphere(20.0), bounds), 0.1, 1e-3) << "near the top";
}

TEST(AdaptiveLayers, OfOneSlopeAreEquallyHigh) {
  // 60 deg from the bed: n_z = 0.5.
  const Mesh mesh = revolved({{10.0, 0.0}, {10.0 - 8.0 / std::tan(M_PI / 3.0), 8.0}});
  const AdaptiveLayers layers = adaptiveLayers(mesh, adaptive());
  EXPECT_EQ(layers.bounds.size(), 40U);
  for (const LayerBounds& layer : layers.bounds) EXPECT_NEAR(layer.height(), 0.2, 1e-4);
  EXPECT_NEAR(greatestCusp(mesh, layers.bounds), 0.1, 1e-4);
}

TEST(AdaptiveLayers, EndAtLevelFaces) {
  const Mesh mesh = revolved({{10.0, 0.0}, {10.0, 3.07}, {7.0, 3.07}, {7.0, 7.3}, {4.0, 7.3}, {4.0, 9.0}});
  const AdaptiveLayers layers = adaptiveLayers(mesh, adaptive());
  expectStacked(layers.bounds);
  EXPECT_TRUE(endsAt(layers.bounds, 3.07));
  EXPECT_TRUE(endsAt(layers.bounds, 7.3));
  EXPECT_TRUE(endsAt(layers.bounds, 9.0));
  EXPECT_TRUE(layers.missed.empty());
  for (const LayerBounds& layer : layers.bounds) EXPECT_LE(layer.height(), 0.3 + 1e-9);
}

TEST(AdaptiveLayers, TellOfLevelFacesTheyCannotEndAt) {
  // From 0.2 mm, layers of 0.2 to 0.3 mm reach 0.4 ... 0.5, but not 0.55 mm; 0.5 is nearest.
  SlicingSettings settings = adaptive();
  settings.adaptive.least_mm = 0.2;
  const Mesh mesh = revolved({{10.0, 0.0}, {10.0, 0.55}, {7.0, 0.55}, {7.0, 5.0}});
  const AdaptiveLayers layers = adaptiveLayers(mesh, settings);
  ASSERT_EQ(layers.missed.size(), 1U);
  EXPECT_NEAR(layers.missed[0].z_mm, 0.55, 1e-9);
  EXPECT_NEAR(layers.missed[0].off_mm, 0.05, 1e-9);
  EXPECT_TRUE(endsAt(layers.bounds, 5.0));
}

TEST(AdaptiveLayers, KeepTheRatioOfNeighboursOnBothSides) {
  // A cone of 45 deg between cylinders asks for 0.14 mm amid 0.3 mm.
  SlicingSettings settings = adaptive();
  settings.adaptive.greatest_ratio = 1.2;
  const Mesh mesh = revolved({{10.0, 0.0}, {10.0, 6.0}, {8.0, 8.0}, {8.0, 14.0}});
  const AdaptiveLayers layers = adaptiveLayers(mesh, settings);
  expectStacked(layers.bounds);
  for (std::size_t i = 1; i < layers.bounds.size(); ++i) {
    const double ratio = layers.bounds[i].height() / layers.bounds[i - 1].height();
    EXPECT_LE(std::max(ratio, 1.0 / ratio), 1.2 + 1e-6) << i;
  }
  EXPECT_LE(greatestCusp(mesh, layers.bounds), 0.1 + 1e-9);
  EXPECT_NEAR(layerHeightAt(layers.bounds, 7.0), 0.1 * std::sqrt(2.0), 0.005);
  EXPECT_GT(layerHeightAt(layers.bounds, 3.0), 0.27);
}

TEST(AdaptiveLayers, AreMultiplesOfTheQuantum) {
  SlicingSettings settings = adaptive();
  settings.adaptive.quantum_mm = 0.04;
  const Mesh mesh = hemisphere(20.0);
  const AdaptiveLayers layers = adaptiveLayers(mesh, settings);
  expectStacked(layers.bounds);
  for (const LayerBounds& layer : layers.bounds) {
    const double multiple = layer.height() / 0.04;
    EXPECT_NEAR(multiple, std::round(multiple), 1e-6);
  }
  EXPECT_LE(greatestCusp(mesh, layers.bounds), 0.12 + 1e-9);  // the least multiple is 0.12 mm
}

TEST(AdaptiveLayers, GiveTheFirstLayerItsOwnHeight) {
  SlicingSettings settings = adaptive();
  settings.first_layer_height_mm = 0.25;
  const AdaptiveLayers layers = adaptiveLayers(revolved({{10.0, 1.0}, {10.0, 9.0}}), settings);
  EXPECT_DOUBLE_EQ(layers.bounds.front().bottom_mm, 1.0);
  EXPECT_DOUBLE_EQ(layers.bounds.front().top_mm, 1.25);
}

TEST(AdaptiveLayers, AreNoneOfAPartThinnerThanHalfTheFirst) {
  EXPECT_TRUE(adaptiveLayers(revolved({{10.0, 0.0}, {10.0, 0.09}}), adaptive()).bounds.empty());
  EXPECT_EQ(adaptiveLayers(revolved({{10.0, 0.0}, {10.0, 0.15}}), adaptive()).bounds.size(), 1U);
}

TEST(AdaptiveLayers, RefuseAQuantumWithoutMultipleBetweenTheBounds) {
  SlicingSettings settings = adaptive();
  settings.adaptive.quantum_mm = 0.35;
  EXPECT_THROW(adaptiveLayers(hemisphere(5.0), settings), InvalidConfig);
}

RC_GTEST_PROP(AdaptiveLayersProperty, KeepBoundsCuspAndRatio, ()) {
  const auto step = [](int low, int high) { return *rc::gen::inRange(low, high) / 100.0; };
  std::vector<Point2> profile = {{20.0, 0.0}};
  for (int i = 0; i < 6; ++i)
    profile.emplace_back(std::max(2.0, profile.back().x() + step(-300, 200)),
                         profile.back().y() + step(*rc::gen::arbitrary<bool>() ? 0 : 40, 500));
  profile.emplace_back(profile.back().x(), profile.back().y() + 1.0);
  const Mesh mesh = revolved(profile);
  const AdaptiveLayers layers = adaptiveLayers(mesh, adaptive());
  RC_ASSERT(layers.bounds.size() > 1U);
  for (std::size_t i = 1; i < layers.bounds.size(); ++i) {
    RC_ASSERT(layers.bounds[i].bottom_mm == layers.bounds[i - 1].top_mm);
    RC_ASSERT(layers.bounds[i].height() > 0.1 - 1e-9);
    RC_ASSERT(layers.bounds[i].height() < 0.3 + 1e-9);
  }
  const std::vector<LayerBounds> above_first(layers.bounds.begin() + 1, layers.bounds.end());
  RC_ASSERT(greatestCusp(mesh, above_first) < 0.1 + 1e-9);
}

}  // namespace
}  // namespace lamina
