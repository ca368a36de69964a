// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>

#include "lamina/base/parallel.hpp"
#include "lamina/base/random.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

/// A closed ball with random bumps of up to 40 %, around the origin.
Mesh randomStar(std::uint64_t seed) {
  Random random(seed);
  const auto rings = static_cast<std::uint32_t>(3 + random.below(20));
  const auto around = static_cast<std::uint32_t>(3 + random.below(30));
  return test::starShaped(rings, around,
                          [&random](double, double) { return 10.0 * random.uniform(0.6, 1.4); });
}

/// Planes in the middles of `count` equal layers.
std::vector<double> middles(const Mesh& mesh, std::size_t count) {
  const Box3 box = boundingBox(mesh);
  std::vector<double> heights;
  for (std::size_t i = 0; i < count; ++i)
    heights.push_back(box.low.z() +
                      box.size().z() * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
  return heights;
}

std::vector<Section> planarSlicerPropertiesSlice(const Mesh& mesh, const std::vector<double>& heights) {
  NoProgress progress;
  return sliceMesh(mesh, heights, progress);
}

double slicedVolume(const Mesh& mesh, std::size_t layers) {
  double area_sum = 0.0;
  for (const Section& section : planarSlicerPropertiesSlice(mesh, middles(mesh, layers)))
    area_sum += signedArea(section.contours);
  return area_sum * boundingBox(mesh).size().z() / static_cast<double>(layers);
}

bool areSame(const std::vector<Section>& a, const std::vector<Section>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Section& s, const Section& t) {
    return s.contours == t.contours && s.open_contours == t.open_contours;
  });
}

TEST(PlanarSlicerProperties, AClosedMeshGivesClosedContoursOnly) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    for (const Section& section :
         planarSlicerPropertiesSlice(randomStar(seed), middles(randomStar(seed), 37))) {
      RC_ASSERT(section.open_contours.empty());
      RC_ASSERT(!section.contours.empty());
      RC_ASSERT(signedArea(section.contours) > 0.0);
    }
  }));
}

TEST(PlanarSlicerProperties, PlanesThroughVerticesGiveClosedContoursOnly) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Mesh mesh = randomStar(seed);
    std::vector<double> heights;
    for (const Point3& vertex : mesh.vertices) heights.push_back(vertex.z());
    std::sort(heights.begin(), heights.end());
    for (const Section& section : planarSlicerPropertiesSlice(mesh, heights))
      RC_ASSERT(section.open_contours.empty());
  }));
}

TEST(PlanarSlicerProperties, TheSumOfAreasConvergesToTheVolume) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Mesh mesh = randomStar(seed);
    // The midpoint rule on an area that is piecewise quadratic in z: the error falls with the square of the
    // layer height.
    RC_ASSERT(std::abs(slicedVolume(mesh, 4000) / volume(mesh) - 1.0) < 1e-4);
  }));
}

TEST(PlanarSlicerProperties, WindingReportsMaterialFromHoles) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Mesh cavity = randomStar(seed);
    for (Point3& vertex : cavity.vertices) vertex *= 0.25;
    const Mesh hollow = joined(randomStar(seed), test::turnedInsideOut(cavity));
    const Section section = planarSlicerPropertiesSlice(hollow, {0.0}).front();
    // The cavity is the part at a quarter of its size.
    RC_ASSERT(section.contours.size() == 2U);
    const auto [hole, outer] =
        std::minmax({signedArea(section.contours[0]), signedArea(section.contours[1])});
    RC_ASSERT(outer > 0.0);
    RC_ASSERT(std::abs(hole + outer / 16.0) < 1e-9 * outer);
  }));
}

TEST(PlanarSlicerProperties, ThreadsChangeNothing) {
  const Mesh mesh = randomStar(7);
  const std::vector<double> heights = middles(mesh, 500);
  const auto expected = planarSlicerPropertiesSlice(mesh, heights);
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    EXPECT_TRUE(areSame(planarSlicerPropertiesSlice(mesh, heights), expected));
  }
}

TEST(PlanarSlicerProperties, RenumberingVerticesChangesNothing) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Mesh mesh = randomStar(seed);
    std::vector<std::uint32_t> order(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    Random random(seed + 1);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    Mesh renumbered = mesh;
    for (std::size_t v = 0; v < order.size(); ++v) renumbered.vertices[order[v]] = mesh.vertices[v];
    for (Triangle& t : renumbered.triangles) t = {order[t[0]], order[t[1]], order[t[2]]};
    RC_ASSERT(areSame(planarSlicerPropertiesSlice(mesh, middles(mesh, 25)),
                      planarSlicerPropertiesSlice(renumbered, middles(mesh, 25))));
  }));
}

TEST(PlanarSlicerProperties, MovingTheMeshMovesTheContours) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Mesh mesh = randomStar(seed);
    // Coordinates on a grid of 2^-20 mm, so that adding a whole number rounds nothing.
    Mesh here = mesh;
    for (Point3& vertex : here.vertices) vertex = (vertex * 0x1p20).array().round().matrix() * 0x1p-20;
    Mesh there = here;
    for (Point3& vertex : there.vertices) vertex += Point3(64.0, -32.0, 16.0);
    const auto a = planarSlicerPropertiesSlice(here, {-1.0, 0.5, 2.0});
    const auto b = planarSlicerPropertiesSlice(there, {15.0, 16.5, 18.0});
    for (std::size_t i = 0; i < a.size(); ++i) {
      RC_ASSERT(a[i].contours.size() == b[i].contours.size());
      RC_ASSERT(std::abs(signedArea(a[i].contours) - signedArea(b[i].contours)) < 1e-9);
    }
  }));
}

}  // namespace
}  // namespace lamina
