// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/geodesic.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <Eigen/Geometry>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "support/surfaces.hpp"

namespace lamina {
namespace {

using namespace test;

double greatestErrorInPlane(const Mesh& mesh, std::uint32_t source) {
  const std::vector<double> distance = GeodesicDistances(mesh).from(source);
  double error = 0.0;
  for (std::size_t i = 0; i < distance.size(); ++i)
    error = std::max(error, std::abs(distance[i] - (mesh.vertices[i] - mesh.vertices[source]).norm()));
  return error;
}

/// Mean over the vertices of the error as a share of the true distance.
template <class Truth>
double meanError(const Mesh& mesh, std::uint32_t source, const Truth& truth) {
  const std::vector<double> distance = GeodesicDistances(mesh).from(source);
  double sum = 0.0;
  for (std::uint32_t i = 0; i < distance.size(); ++i)
    if (i != source) sum += std::abs(distance[i] / truth(mesh.vertices[i]) - 1.0);
  return sum / static_cast<double>(distance.size() - 1);
}

TEST(Geodesic, OnAPlaneDistancesAreStraightLines) {
  const Mesh plate = plateMesh(20, 10, 20.0, 10.0);
  for (const std::uint32_t source : {0U, 20U, 115U}) EXPECT_LT(greatestErrorInPlane(plate, source), 1e-9);
}

TEST(Geodesic, ObtuseTrianglesAreNoObstacle) {
  const Mesh sheared =
      patch(12, 12, [](double u, double v) { return Point3(10.0 * u + 25.0 * v, 6.0 * v, 0.0); });
  for (const std::uint32_t source : {0U, 12U, 84U}) EXPECT_LT(greatestErrorInPlane(sheared, source), 1e-8);
}

TEST(Geodesic, AnyTrianglesOfAConvexPlaneGiveStraightLines) {
  EXPECT_TRUE(rc::check([] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Mesh plate = plateMesh(9, 9, 9.0, 9.0);
    for (Point3& vertex : plate.vertices)
      if (vertex.x() > 0.5 && vertex.x() < 8.5 && vertex.y() > 0.5 && vertex.y() < 8.5)
        vertex += Point3(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0.0);
    RC_ASSERT(greatestErrorInPlane(plate, static_cast<std::uint32_t>(random.below(100))) < 1e-7);
  }));
}

TEST(Geodesic, OnASphereTheyAreGreatCircles) {
  const Mesh sphere = capMesh(96, 48, 10.0, 0.9 * M_PI);
  for (const std::uint32_t source : {0U, 96U * 20U}) {
    const Point3 from = sphere.vertices[source].normalized();
    EXPECT_LT(meanError(sphere, source,
                        [&](const Point3& to) {
                          return 10.0 *
                                 std::atan2(from.cross(to.normalized()).norm(), from.dot(to.normalized()));
                        }),
              source == 0 ? 0.002 : 0.006);
  }
}

TEST(Geodesic, OnAConeTheyAreStraightOnceItIsUnrolled) {
  const Mesh cone = coneMesh(96, 40, 20.0);
  const std::uint32_t source = 96 * 29 + 1;  // at three quarters of the slope, angle 0
  EXPECT_LT(meanError(cone, source,
                      [](const Point3& to) {
                        const double turn = std::abs(std::atan2(to.y(), to.x())) * std::sqrt(0.5);
                        const double slope = to.norm();
                        return std::sqrt(slope * slope + 225.0 - 30.0 * slope * std::cos(turn));
                      }),
            0.002);
}

TEST(Geodesic, CoarseSpheresAreGoodToAPercent) {
  const Mesh sphere = capMesh(32, 16, 7.0, 15.0 / 16.0 * M_PI);
  EXPECT_LT(meanError(sphere, 0, [](const Point3& to) { return 7.0 * std::acos(to.z() / 7.0); }), 0.01);
}

TEST(Geodesic, AWayAroundAHoleIsLonger) {
  const Mesh plate = plateMesh(10, 10, 10.0, 10.0);
  Mesh holed = plate;
  holed.triangles.clear();
  for (const Triangle& corner : plate.triangles) {
    const Point3 middle =
        (plate.vertices[corner[0]] + plate.vertices[corner[1]] + plate.vertices[corner[2]]) / 3.0;
    if (std::abs(middle.x() - 5.0) > 2.0 || std::abs(middle.y() - 5.0) > 2.0)
      holed.triangles.push_back(corner);
  }
  // From the middle of the left side to that of the right one, around two corners of the hole.
  const double truth = 2.0 * std::sqrt(13.0) + 4.0;
  EXPECT_NEAR(GeodesicDistances(holed).from(55)[65], truth, 0.03 * truth);
}

TEST(Geodesic, SourcesInALineCountAsTheLine) {
  const Mesh plate = plateMesh(12, 8, 12.0, 8.0);
  std::vector<GeodesicSource> left_side;
  for (std::uint32_t j = 0; j <= 8; ++j) left_side.push_back({13 * j, 0.0});
  const std::vector<double> distance = GeodesicDistances(plate).from(left_side);
  for (std::size_t i = 0; i < distance.size(); ++i) EXPECT_NEAR(distance[i], plate.vertices[i].x(), 1e-9);
}

TEST(Geodesic, TheNearestSourceCountsWithItsStart) {
  const Mesh plate = plateMesh(20, 20, 20.0, 20.0);
  const std::vector<double> distance = GeodesicDistances(plate).from({{0, 4.0}, {440, 0.0}});
  for (std::size_t i = 0; i < distance.size(); ++i) {
    const double truth =
        std::min(4.0 + plate.vertices[i].norm(), (plate.vertices[i] - Point3(20.0, 20.0, 0.0)).norm());
    EXPECT_NEAR(distance[i], truth, 0.2);  // a fifth of a cell, where the fronts meet
  }
}

TEST(Geodesic, WhereNoWayLeadsIsInfinitelyFar) {
  Mesh plates = plateMesh(2, 2, 1.0, 1.0);
  const Mesh other = plateMesh(1, 1, 1.0, 1.0);
  for (const Point3& vertex : other.vertices) plates.vertices.emplace_back(vertex + Point3(5.0, 0.0, 0.0));
  for (const Triangle& corner : other.triangles)
    plates.triangles.push_back({corner[0] + 9, corner[1] + 9, corner[2] + 9});
  const std::vector<double> distance = GeodesicDistances(plates).from(0);
  for (std::size_t i = 0; i < distance.size(); ++i) EXPECT_EQ(std::isinf(distance[i]), i >= 9);
}

TEST(Geodesic, TrianglesWithoutAreaJoinWhatTheyLieBetween) {
  // The side from (0, 0) to (2, 0) of one triangle is halved for those beyond it.
  Mesh mesh;
  mesh.vertices = {{0.0, 0.0, 0.0},  {2.0, 0.0, 0.0}, {1.0, 0.0, 0.0},
                   {1.0, -1.0, 0.0}, {1.0, 2.0, 0.0}, {1.0, 2.0, 0.0}};
  mesh.triangles = {{0, 3, 1}, {0, 1, 2}, {0, 2, 4}, {2, 1, 4}, {1, 5, 4}};
  const std::vector<double> distance = GeodesicDistances(mesh).from(3);
  EXPECT_NEAR(distance[2], 1.0, 1e-12);
  EXPECT_NEAR(distance[4], 3.0, 1e-12);
  EXPECT_NEAR(distance[5], 3.0, 1e-12);
}

TEST(Geodesic, AWayDownEndsAtTheSource) {
  const Mesh plate = plateMesh(10, 10, 10.0, 10.0);
  const GeodesicDistances geodesics(plate);
  const std::vector<double> distance = geodesics.from(0);
  const std::vector<std::uint32_t> way = geodesics.descend(distance, 120);
  for (std::size_t i = 1; i < way.size(); ++i) EXPECT_LT(distance[way[i]], distance[way[i - 1]]);
  EXPECT_EQ(way.front(), 120U);
  EXPECT_EQ(way.back(), 0U);
}

TEST(Geodesic, WhatIsNotThereIsRefused) {
  Mesh plate = plateMesh(2, 2, 1.0, 1.0);
  const GeodesicDistances geodesics(plate);
  EXPECT_THROW(geodesics.from(9), InvalidInput);
  EXPECT_THROW(geodesics.from({{0, -1.0}}), InvalidInput);
  plate.triangles.push_back({0, 1, 9});
  EXPECT_THROW(GeodesicDistances{plate}, InvalidMesh);
}

}  // namespace
}  // namespace lamina
