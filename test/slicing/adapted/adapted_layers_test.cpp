// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adapted/adapted_layers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "support/directions.hpp"
#include "support/lofted_solid.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kSpare = 2e-3;  // mm: by which points that are left out may change both curves

AdaptedLayers adapted(const Mesh& mesh, double height_mm, AdaptedSettings settings = {}) {
  SlicingSettings slicing;
  slicing.layer_height_mm = height_mm;
  slicing.first_layer_height_mm = height_mm;
  NoProgress progress;
  return adaptedLayers(mesh, slicing, settings, progress);
}

/// A wall that leans outwards by theta all round, 20 mm in radius at the bottom.
Mesh cone(double theta_deg, double height_mm) {
  const double slope = std::tan(theta_deg * kDegree);
  return test::loftedSolid({0.0, height_mm}, 360, [slope](double, double z) { return 20.0 + slope * z; });
}

/// Whether a point lies where facets meet.
bool isOnEdge(const Point3& point) {
  return std::abs(std::remainder(std::atan2(point.y(), point.x()), 2.0 * kDegree)) < 1e-9;
}

/// A wall that leans one way: 45 degrees at phi = 0, vertical at 180.
Mesh leaningOneWay(double height_mm) {
  return test::loftedSolid({0.0, height_mm}, 360,
                           [](double phi, double z) { return 20.0 + z * (1.0 + std::cos(phi)) / 2.0; });
}

AdaptedSettings coarse() {
  AdaptedSettings settings;
  settings.step_mm = 2.0;
  return settings;
}

/// Height of the curve where it crosses a heading; of a curve that does not, NaN.
double heightAt(const AdaptedCurve& curve, double heading) {
  double nearest = 1.0 * kDegree;
  double z = std::numeric_limits<double>::quiet_NaN();
  for (const Point3& point : curve.points) {
    const double off = std::abs(std::remainder(std::atan2(point.y(), point.x()) - heading, 2.0 * M_PI));
    if (off < nearest) z = point.z();
    nearest = std::min(nearest, off);
  }
  return z;
}

/// By looking at every segment.
double distanceTo(const AdaptedCurve& curve, const Point3& point) {
  double least = std::numeric_limits<double>::infinity();
  const std::size_t count = curve.points.size();
  for (std::size_t i = 0; i + (curve.is_closed ? 0 : 1) < count; ++i) {
    const Point3& from = curve.points[i];
    const Point3 along = curve.points[(i + 1) % count] - from;
    const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (from + share * along - point).norm());
  }
  return least;
}

TEST(AdaptedLayers, OfAWallThatLeansAlikeAllRoundStayPlane) {
  const std::vector<std::pair<double, double>> tops = {
      {0.0, 32.000}, {20.0, 30.070}, {30.0, 27.713}, {45.0, 22.627}};
  for (const auto& [theta_deg, top_mm] : tops) {
    const Mesh mesh = cone(theta_deg, 40.0);
    const NearestTriangle wall(mesh);
    const AdaptedLayers layers = adapted(mesh, 1.6, coarse());
    ASSERT_GE(layers.layers.size(), 20U);
    for (std::size_t k = 0; k < 20; ++k) {
      const double z = 1.6 * static_cast<double>(k + 1) * std::cos(theta_deg * kDegree);
      ASSERT_EQ(layers.layers[k].curves.size(), 1U);
      for (const Point3& point : layers.layers[k].curves[0].points) {
        EXPECT_LE(wall.nearest(point).distance_mm, 1e-9);
        // Facets lean a little less than their edges, which are on the cone.
        EXPECT_NEAR(point.z(), z, isOnEdge(point) ? 1e-9 : 2e-3);
        if (isOnEdge(point)) {
          EXPECT_NEAR(point.head<2>().norm(), 20.0 + std::tan(theta_deg * kDegree) * point.z(), 1e-9);
        }
      }
    }
    EXPECT_NEAR(layers.layers[19].curves[0].points[0].z(), top_mm, 5e-4);
  }
}

TEST(AdaptedLayers, ToolsLieInTheWall) {
  const AdaptedLayers layers = adapted(cone(30.0, 20.0), 1.6, coarse());
  for (const AdaptedLayer& layer : layers.layers) {
    for (const AdaptedCurve& curve : layer.curves) {
      for (std::size_t i = 0; i < curve.points.size(); ++i) {
        EXPECT_NEAR(std::acos(curve.axis[i].z()) / kDegree, 30.0, 0.05);
        EXPECT_GT(curve.axis[i].head<2>().dot(curve.points[i].head<2>()), 0.0);
        EXPECT_NEAR(curve.height_mm[i], 1.6, 1e-9);
      }
    }
  }
}

TEST(AdaptedLayers, OfAWallThatLeansOneWayAreNotPlane) {
  const AdaptedLayers layers = adapted(leaningOneWay(24.0), 1.6, coarse());
  const AdaptedCurve& tenth = layers.layers[9].curves[0];
  EXPECT_NEAR(heightAt(tenth, 0.0), 11.314, 1e-3);
  EXPECT_NEAR(heightAt(tenth, M_PI), 16.000, 1e-3);
  for (std::size_t k = 1; k < 10; ++k) {
    const AdaptedCurve& curve = layers.layers[k].curves[0];
    for (const Point3& point : curve.points)
      EXPECT_NEAR(distanceTo(layers.layers[k - 1].curves[0], point), 1.600, 2e-3);
  }
}

TEST(AdaptedLayers, AWallAt45DegreesNeedsMoreOfThemByItsLength) {
  AdaptedSettings settings;
  settings.step_mm = 10.0;
  const double height_mm = 0.5;
  const AdaptedLayers layers = adapted(cone(45.0, 100.0), height_mm, settings);
  const double wall_mm = 100.0 * std::sqrt(2.0);
  EXPECT_EQ(layers.layers.size(), static_cast<std::size_t>(std::lround(wall_mm / height_mm)));
  EXPECT_NEAR(static_cast<double>(layers.layers.size()) / 200.0, 1.414, 0.005);
  EXPECT_EQ(layers.completing, 0U);
}

TEST(AdaptedLayers, TheTopIsCompletedByOpenCurves) {
  const double height_mm = 1.6;
  const double top_mm = 24.0;
  const AdaptedLayers layers = adapted(leaningOneWay(top_mm), height_mm, coarse());
  ASSERT_GT(layers.completing, 0U);
  const std::size_t flat = layers.layers.size() - layers.completing;
  EXPECT_EQ(flat, 15U);
  for (std::size_t k = 0; k < layers.layers.size(); ++k) {
    ASSERT_EQ(layers.layers[k].curves.size(), 1U);
    EXPECT_EQ(layers.layers[k].curves[0].is_closed, k < flat);
    for (const Point3& axis : layers.layers[k].curves[0].axis) EXPECT_NEAR(axis.norm(), 1.0, 1e-12);
  }
  for (int j = 0; j < 180; ++j) {
    const double phi = 2.0 * M_PI * j / 180;
    const double r = 20.0 + top_mm * (1.0 + std::cos(phi)) / 2.0;
    const Point3 rim(r * std::cos(phi), r * std::sin(phi), top_mm);
    double least = std::numeric_limits<double>::infinity();
    for (const AdaptedLayer& layer : layers.layers) least = std::min(least, distanceTo(layer.curves[0], rim));
    EXPECT_LE(least, height_mm + 1e-6);
  }
}

/// A barrel whose walls bend with a radius of 20 mm, at most 45 degrees from the vertical.
Mesh barrel() {
  std::vector<double> heights;
  for (int i = 0; i <= 560; ++i) heights.push_back(0.05 * i);
  return test::loftedSolid(
      heights, 120, [](double, double z) { return 10.0 + std::sqrt(400.0 - (z - 14.0) * (z - 14.0)); });
}

TEST(AdaptedLayers, BetweenComputedOnesAreInterpolatedOnTheWall) {
  const Mesh mesh = barrel();
  const NearestTriangle wall(mesh);
  // Of the interpolation, and of the flat contours, which are farther apart along the wall.
  const double sagitta = (1.6 * 1.6 + 1.6 * 1.6 * 2.0) / (8.0 * 20.0);
  for (const std::size_t parts : {16U, 8U}) {
    AdaptedSettings settings = coarse();
    settings.computing_height_mm = 1.6;
    const AdaptedLayers layers = adapted(mesh, 1.6 / static_cast<double>(parts), settings);
    // 16 or 8 curves each: as many as the wall is long.
    const double wall_mm = 2.0 * 20.0 * std::asin(14.0 / 20.0);
    EXPECT_EQ(layers.layers.size(),
              static_cast<std::size_t>(std::lround(wall_mm / 1.6 * static_cast<double>(parts))));
    double greatest = 0.0;
    for (const AdaptedLayer& layer : layers.layers)
      for (const AdaptedCurve& curve : layer.curves)
        for (const Point3& point : curve.points)
          greatest = std::max(greatest, wall.nearest(point).distance_mm);
    EXPECT_LE(greatest, sagitta);
  }
}

TEST(AdaptedLayers, KeepTheCornersOfTheWall) {
  // 10 mm wide, faces upright from 2.93 to 7.07 mm; layers stay behind at the edges, which lean more below.
  SlicingSettings slicing;
  slicing.layer_height_mm = slicing.first_layer_height_mm = 0.2;
  NoProgress progress;
  const AdaptedLayers layers = adaptedLayers(makePart("bevelled_cube"), slicing, {}, progress);
  std::size_t upright = 0;
  for (const AdaptedLayer& layer : layers.layers)
    for (const AdaptedCurve& curve : layer.curves) {
      Box3 box{curve.points.front(), curve.points.front()};
      for (const Point3& point : curve.points) box.include(point);
      if (box.low.z() < 3.0 || box.high.z() > 7.0) continue;
      ++upright;
      for (const Point2& corner : {Point2(5, 5), Point2(-5, 5), Point2(-5, -5), Point2(5, -5)}) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Point3& point : curve.points)
          nearest = std::min(nearest, (point.head<2>() - corner).norm());
        EXPECT_LE(nearest, 0.01) << box.low.z();
      }
    }
  EXPECT_GE(upright, 10U);
}

TEST(AdaptedLayers, HolesAreWallsOfTheirOwn) {
  const AdaptedLayers layers = adapted(makePart("tube"), 0.5, coarse());
  for (const AdaptedLayer& layer : layers.layers) {
    ASSERT_EQ(layer.curves.size(), 2U);
    for (const AdaptedCurve& curve : layer.curves) EXPECT_TRUE(curve.is_closed);
  }
  EXPECT_EQ(layers.completing, 0U);
}

TEST(AdaptedLayers, StandOnTheLayerBelowWhereverWallsLean) {
  EXPECT_TRUE(rc::check([] {
    const double all_round = test::anyNumber(-0.3, 0.4);
    const double one_way = test::anyNumber(0.0, 0.4);
    const double heading = test::anyNumber(0.0, 2.0 * M_PI);
    const Mesh mesh = test::loftedSolid({0.0, 5.0}, 60, [&](double phi, double z) {
      return 12.0 + z * (all_round + one_way * std::cos(phi - heading));
    });
    const NearestTriangle wall(mesh);
    const AdaptedLayers layers = adapted(mesh, 0.8, coarse());
    for (std::size_t k = 0; k < layers.layers.size(); ++k) {
      for (const AdaptedCurve& curve : layers.layers[k].curves) {
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
          RC_ASSERT(wall.nearest(curve.points[i]).distance_mm <= 0.02);
          RC_ASSERT(std::abs(curve.axis[i].norm() - 1.0) <= 1e-12);
          RC_ASSERT(curve.height_mm[i] <= 0.8 + 1e-6);
          if (k == 0 || !curve.is_closed) continue;
          RC_ASSERT(distanceTo(layers.layers[k - 1].curves[0], curve.points[i]) <= 0.8 + kSpare);
        }
      }
    }
  }));
}

TEST(AdaptedLayers, EndInTheTipOfACone) {
  const Mesh cone_mesh = makePart("cone");
  const AdaptedLayers layers = adapted(cone_mesh, 0.5);
  ASSERT_FALSE(layers.layers.back().curves.empty());
  for (const AdaptedLayer& layer : layers.layers)
    for (const AdaptedCurve& curve : layer.curves) EXPECT_GE(curve.points.size(), 2U);
  EXPECT_NEAR(layers.layers.back().curves[0].points[0].z(), boundingBox(cone_mesh).high.z(), 1.0);
}

TEST(AdaptedLayers, SmoothingStraightensAndKeepsTheSpacing) {
  AdaptedSettings settings = coarse();
  settings.smoothing_window = 5;
  const Mesh box = test::boxBetween({0, 0, 0}, {20, 20, 5});
  const AdaptedLayers layers = adapted(box, 1.0, settings);
  const AdaptedCurve& curve = layers.layers[2].curves[0];
  for (const Point3& corner : {Point3(0, 0, 3), Point3(20, 20, 3)}) EXPECT_GT(distanceTo(curve, corner), 0.5);
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    EXPECT_LE((curve.points[(i + 1) % curve.points.size()] - curve.points[i]).norm(), 2.0 + 1e-9);
  settings.smoothing_window = 4;
  EXPECT_THROW(adapted(box, 1.0, settings), InvalidConfig);
}

TEST(AdaptedLayers, APartWithFlatPartsInBetweenIsRefusedWithThem) {
  const Mesh sphere = makePart("sphere", {{"radius_mm", "7"}});
  try {
    adapted(sphere, 0.5);
    FAIL() << "no refusal";
  } catch (const Unsliceable& error) {
    EXPECT_NE(std::string(error.what()).find("adapted.max_lean_deg = 60"), std::string::npos) << error.what();
    EXPECT_FALSE(error.region().triangles.empty());
    EXPECT_LT(error.region().triangles.size(), sphere.triangles.size());
  }
}

/// Two steep pyramids base to base, between z = 2 and z = 8.
Mesh spindle() {
  Mesh mesh = test::octahedron();
  for (Point3& vertex : mesh.vertices) vertex = Point3(10.0 + vertex.x(), vertex.y(), 5.0 + 3.0 * vertex.z());
  return mesh;
}

TEST(AdaptedLayers, WallsThatBeginAboveTheBottomAreRefused) {
  const Mesh two = joined(test::boxBetween({0, 0, 0}, {5, 5, 10}), spindle());
  AdaptedSettings settings;
  settings.max_lean_deg = 80.0;
  EXPECT_THROW(adapted(two, 1.0, settings), Unsliceable);
}

/// A block of 30 x 10 x 20 mm with a notch from its middle height to its top, 8 mm wide there: its wall
/// splits at z = 10. Its faces lean by 21.8 degrees.
Mesh notchedBlock() {
  const std::vector<Point2> profile = {{0, 0}, {30, 0}, {30, 20}, {19, 20}, {15, 10}, {11, 20}, {0, 20}};
  const std::vector<Triangle> cap = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 5}, {0, 5, 6}};
  const auto count = static_cast<std::uint32_t>(profile.size());
  Mesh mesh;
  for (const double y : {0.0, 10.0})
    for (const Point2& point : profile) mesh.vertices.emplace_back(point.x(), y, point.y());
  for (const Triangle& t : cap) {
    mesh.triangles.push_back(t);
    mesh.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    mesh.triangles.push_back({i, i + count, j + count});
    mesh.triangles.push_back({i, j + count, j});
  }
  return mesh;
}

void expectRefusalNaming(const Mesh& mesh, const std::string& words) {
  try {
    adapted(mesh, 0.5);
    FAIL() << "no refusal";
  } catch (const Unsliceable& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_FALSE(error.region().triangles.empty());
  }
}

TEST(AdaptedLayers, AWallThatSplitsIsRefusedWithTheHeight) {
  const Mesh block = notchedBlock();
  ASSERT_DOUBLE_EQ(volume(block), 10.0 * (30.0 * 20.0 - 0.5 * 8.0 * 10.0));
  expectRefusalNaming(block,
                      "a wall splits or begins between z = 9.500 mm (1 loop) and z = 10.000 mm (2 loops)");
}

TEST(AdaptedLayers, WallsThatMergeAreRefusedWithTheHeight) {
  Mesh block = notchedBlock();
  for (Point3& vertex : block.vertices) vertex = Point3(30.0 - vertex.x(), vertex.y(), 20.0 - vertex.z());
  expectRefusalNaming(block, "walls merge or end between z = 9.500 mm (2 loops) and z = 10.000 mm (1 loop)");
}

TEST(AdaptedLayers, WallsThatLeaveEachOtherBehindAreRefusedWithThePlace) {
  // A flat face beside a cone that leans: the corner between them gets too steep for a layer.
  try {
    adapted(makePart("semi_cone"), 0.2);
    FAIL() << "no refusal";
  } catch (const Unsliceable& error) {
    EXPECT_NE(std::string(error.what()).find("gap"), std::string::npos) << error.what();
    EXPECT_FALSE(error.region().triangles.empty());
  }
}

TEST(AdaptedLayers, AComputingHeightMustBeAMultiple) {
  AdaptedSettings settings;
  settings.computing_height_mm = 0.5;
  EXPECT_THROW(adapted(cone(0.0, 5.0), 0.2, settings), InvalidConfig);
}

TEST(AdaptedLayers, DoNotDependOnThreads) {
  const auto lastPoint = [] {
    return adapted(leaningOneWay(10.0), 0.8).layers.back().curves.back().points.back();
  };
  const Point3 many = lastPoint();
  const ThreadLimit one(1);
  EXPECT_EQ(lastPoint(), many);
}

}  // namespace
}  // namespace lamina
