// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/flattening.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/parameterization/distortion.hpp"
#include "parameterization/smacof.hpp"
#include "support/surfaces.hpp"

namespace lamina {
namespace {

using namespace test;

FlatteningSettings by(FlatteningMethod method, int landmarks) {
  FlatteningSettings settings;
  settings.method = method;
  settings.landmarks = landmarks;
  return settings;
}

/// Every method, with few landmarks and with all vertices.
class EveryFlattening : public testing::TestWithParam<FlatteningSettings> {
 protected:
  static void expectIsometry(const Mesh& surface, double tolerance) {
    const Distortion distortion = measureDistortion(surface, flatten(surface, GetParam()));
    EXPECT_GT(distortion.least_stretch, 1.0 - tolerance);
    EXPECT_LT(distortion.greatest_stretch, 1.0 + tolerance);
    EXPECT_EQ(distortion.flipped, 0U);
  }
};

// A scaling without the factor 1/2 makes all lengths sqrt(2) times too long.
TEST_P(EveryFlattening, APlaneGridKeepsItsLengths) {
  const Mesh plate = plateMesh(20, 10, 20.0, 10.0);
  const Distortion distortion = measureDistortion(plate, flatten(plate, GetParam()));
  EXPECT_LT(distortion.index_sum, 1e-2);
  expectIsometry(plate, 1e-6);
}

TEST_P(EveryFlattening, AHalfCylinderKeepsItsLengths) {
  expectIsometry(halfCylinderMesh(16, 12, 10.0, 25.0), 0.01);
  const Mesh fine = halfCylinderMesh(40, 30, 10.0, 25.0);
  if (GetParam().landmarks < 1000) expectIsometry(fine, 0.01);
}

// A rectangle rolled onto a cone around z whose slope is twice as long as its radius.
TEST_P(EveryFlattening, APieceOfAConeKeepsItsLengths) {
  const Mesh rolled = patch(20, 16, [](double u, double v) {
    const Point2 unrolled(5.0 + 20.0 * u, 16.0 * v - 8.0);
    const double slope = unrolled.norm();
    const double angle = 2.0 * std::atan2(unrolled.y(), unrolled.x());
    return Point3(0.5 * slope * std::cos(angle), 0.5 * slope * std::sin(angle), -std::sqrt(0.75) * slope);
  });
  expectIsometry(rolled, 0.01);
}

TEST_P(EveryFlattening, TrianglesWindCounterClockwise) {
  Mesh surface = patch(10, 10, [](double u, double v) { return Point3(20.0 * u, 20.0 * v, 4.0 * u * v); });
  EXPECT_EQ(measureDistortion(surface, flatten(surface, GetParam())).flipped, 0U);
  for (Triangle& corner : surface.triangles) std::swap(corner[1], corner[2]);
  EXPECT_EQ(measureDistortion(surface, flatten(surface, GetParam())).flipped, 0U);
}

TEST_P(EveryFlattening, WhatDoesNotHangTogetherIsRefused) {
  Mesh plate = plateMesh(2, 2, 1.0, 1.0);
  plate.vertices.emplace_back(5.0, 5.0, 5.0);
  EXPECT_THROW(flatten(plate, GetParam()), InvalidMesh);
}

INSTANTIATE_TEST_SUITE_P(Flattening, EveryFlattening,
                         testing::Values(by(FlatteningMethod::Arap, 8), by(FlatteningMethod::Mds, 8),
                                         by(FlatteningMethod::Stress, 8), by(FlatteningMethod::Mds, 1000)));

TEST(Flattening, StressIsLessened) {
  const Mesh bump = capMesh(24, 8, 10.0, 0.8);
  const GeodesicDistances geodesics(bump);
  const Landmarks landmarks = spreadLandmarks(geodesics, bump.vertices.size(), 12);
  const std::vector<Point2> parameterization = landmarkMds(landmarks);
  const double before = stressOf(parameterization, geodesics.fans(), landmarks);
  EXPECT_LT(
      stressOf(lessenStress(parameterization, geodesics.fans(), landmarks), geodesics.fans(), landmarks),
      0.9 * before);
}

TEST(Flattening, NothingGivesNothing) { EXPECT_TRUE(flatten({}, {}).empty()); }

}  // namespace
}  // namespace lamina
