// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adapted/adapted_surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "slicing/adapted/harmonic_heights.hpp"
#include "slicing/curved/layer_coverage.hpp"
#include "slicing/curved/part_samples.hpp"
#include "support/lofted_solid.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

std::vector<LayerSurface> surfacesOf(const Mesh& mesh, double height_mm, double step_mm = 2.0) {
  SlicingSettings slicing;
  slicing.layer_height_mm = height_mm;
  slicing.first_layer_height_mm = height_mm;
  AdaptedSettings settings;
  settings.step_mm = 0.5 * step_mm;
  NoProgress progress;
  return adaptedSurfaces(adaptedLayers(mesh, slicing, settings, progress), 0.0, step_mm, progress);
}

TEST(AdaptedSurfaces, OfAConeArePlane) {
  const double slope = std::tan(M_PI / 6.0);
  const Mesh cone =
      test::loftedSolid({0.0, 12.0}, 90, [slope](double, double z) { return 15.0 - slope * z; });
  const std::vector<LayerSurface> surfaces = surfacesOf(cone, 1.0);
  ASSERT_GE(surfaces.size(), 12U);
  const double rise_mm = std::cos(M_PI / 6.0);
  // The last layer is what is left.
  for (std::size_t k = 0; k + 1 < surfaces.size(); ++k) {
    const LayerSurface& surface = surfaces[k];
    // Facets lean a little less than the cone.
    for (std::size_t v = 0; v < surface.tip.size(); ++v) {
      EXPECT_NEAR(surface.tip[v].z(), static_cast<double>(k + 1) * rise_mm, 6e-3);
      EXPECT_NEAR(surface.height_mm[v], rise_mm, 6e-3);
      EXPECT_GT(surface.normal[v].z(), 0.999);
      const Point3 middle = surface.tip[v] - 0.5 * surface.height_mm[v] * surface.normal[v];
      EXPECT_LE((surface.middle.vertices[v] - middle).norm(), 1e-12);
    }
    // Where the wall is half way up the layer.
    const double radius = 15.0 - slope * (static_cast<double>(k) + 0.5) * rise_mm;
    EXPECT_NEAR(surfaceArea(surface.middle), 45.0 * radius * radius * std::sin(M_PI / 45.0), 0.5);
  }
}

TEST(AdaptedSurfaces, OfAWallThatLeansOneWayRiseFromItToTheOther) {
  const Mesh mesh = test::loftedSolid(
      {0.0, 16.0}, 120, [](double phi, double z) { return 20.0 + z * (1.0 + std::cos(phi)) / 2.0; });
  const std::vector<LayerSurface> surfaces = surfacesOf(mesh, 1.6);
  ASSERT_GT(surfaces.size(), 10U);
  const LayerSurface& last = surfaces[9];
  Box3 box;
  for (const Point3& tip : last.tip) box.include(tip);
  EXPECT_NEAR(box.low.z(), 16.0 * std::sqrt(0.5), 2e-2);
  EXPECT_NEAR(box.high.z(), 16.0, 1e-3);
  for (std::size_t v = 0; v < last.tip.size(); ++v) {
    EXPECT_NEAR(last.normal[v].norm(), 1.0, 1e-12);
    EXPECT_GT(last.normal[v].z(), 0.7);
    EXPECT_GT(last.height_mm[v], 1.0);
    EXPECT_LT(last.height_mm[v], 1.601);
  }
}

TEST(AdaptedSurfaces, FillAPartWithAnUnevenTop) {
  const Mesh mesh = test::loftedSolid(
      {0.0, 12.0}, 120, [](double phi, double z) { return 20.0 + z * (1.0 + std::cos(phi)) / 2.0; });
  double filled_mm3 = 0.0;
  for (const LayerSurface& surface : surfacesOf(mesh, 0.5)) {
    for (const Triangle& corner : surface.middle.triangles) {
      const Mesh one{surface.middle.vertices, {corner}};
      filled_mm3 +=
          surfaceArea(one) *
          (surface.height_mm[corner[0]] + surface.height_mm[corner[1]] + surface.height_mm[corner[2]]) / 3.0;
    }
    for (const Point3& tip : surface.tip) EXPECT_LE(tip.z(), 12.0);
  }
  // Rims that stand on the wall alone count twice, wedges thinner than a quarter of a layer not at all.
  EXPECT_LE(filled_mm3, volume(mesh));
  EXPECT_GE(filled_mm3, 0.972 * volume(mesh));
}

/// The share of the part in no layer and in more than one, by 20 000 points.
std::pair<double, double> openAndDouble(const Mesh& part, double height_mm) {
  const PartSamples samples(part, 20000);
  const std::vector<LayerSurface> surfaces = surfacesOf(part, height_mm, 0.5);
  NoProgress progress;
  double open = 0.0, twice = 0.0;
  for (const std::uint32_t count : layerCounts(samples, {surfaces, {}, {}}, progress)) {
    open += count == 0 ? 1.0 : 0.0;
    twice += count > 1 ? 1.0 : 0.0;
  }
  const auto all = static_cast<double>(samples.points().size());
  return {open / all, twice / all};
}

/// The share of a part that steps of its leaning faces leave open if they lie half in and half out: triangles
/// of half a step's rise and half its run, for layers that are this high along the face.
double openInSteps(const Mesh& part, double height_mm) {
  double steps_mm3 = 0.0;
  for (const Triangle& corner : part.triangles) {
    const Point3& a = part.vertices[corner[0]];
    const Point3 area = 0.5 * (part.vertices[corner[1]] - a).cross(part.vertices[corner[2]] - a);
    const Point3 normal = area.normalized();
    steps_mm3 += area.norm() * height_mm * std::abs(normal.z()) * normal.head<2>().norm() / 8.0;
  }
  return steps_mm3 / volume(part);
}

TEST(AdaptedSurfaces, LeaveLittleMoreThanStepsOpen) {
  struct Case {
    const char* part;
    double height_mm;
    double most_open;
    double beside_steps;
  };
  for (const Case& one :
       {Case{"cone", 0.2, 0.005, 0.002}, Case{"pyramid", 0.2, 0.005, 0.002},
        Case{"tetradecahedron", 0.2, 0.005, 0.003}, Case{"bevelled_cube", 0.2, 0.007, 0.003},
        Case{"bevelled_cube", 0.1, 0.005, 0.003}}) {
    const Mesh part = makePart(one.part);
    const auto [open, twice] = openAndDouble(part, one.height_mm);
    EXPECT_LE(open, one.most_open) << one.part;
    EXPECT_LE(open, openInSteps(part, one.height_mm) + one.beside_steps) << one.part;
    EXPECT_LE(twice, 0.005) << one.part;
  }
}

TEST(HarmonicHeights, OfALinearBorderAreLinear) {
  Random random(4);
  const RegionTriangulation region = triangulated(
      {test::star(random, {0, 0}, 5.0, 9.0, 30), test::reversed(test::circle({0, 0}, 2.0, 20))}, 0.8);
  const auto plane = [](const Point2& point) { return 3.0 + 0.2 * point.x() - 0.5 * point.y(); };
  std::vector<double> border;
  for (std::size_t i = 0; i < region.border.size(); ++i) border.push_back(plane(region.points[i]));
  const std::vector<double> heights = harmonicHeights(region, border);
  ASSERT_EQ(heights.size(), region.points.size());
  for (std::size_t i = 0; i < heights.size(); ++i) EXPECT_NEAR(heights[i], plane(region.points[i]), 1e-9);
}

TEST(HarmonicHeights, RefuseATriangleWithoutArea) {
  RegionTriangulation flat;
  flat.points = {{0, 0}, {2, 0}, {1, 0}};  // two of the border, one inside
  flat.triangles = {{0, 1, 2}};
  EXPECT_THROW(harmonicHeights(flat, {0.0, 1.0}), InvalidInput);
}

}  // namespace
}  // namespace lamina
