// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/arap.hpp"

#include <gtest/gtest.h>

#include "support/surfaces.hpp"

namespace lamina {
namespace {

using namespace test;

std::vector<Point2> projectionOf(const Mesh& mesh) {
  std::vector<Point2> parameterization;
  for (const Point3& vertex : mesh.vertices) parameterization.emplace_back(vertex.head<2>());
  return parameterization;
}

TEST(Arap, AnExactPlanHasNoEnergyAndStays) {
  const Mesh plate = plateMesh(20, 10, 20.0, 10.0);
  const ArapEnergy energy(plate);
  const std::vector<Point2> parameterization = projectionOf(plate);
  EXPECT_NEAR(energy.pullOn(parameterization).energy, 0.0, 1e-20);
  const std::vector<Point2> relaxed = relaxArap(energy, parameterization);
  for (std::size_t i = 0; i < parameterization.size(); ++i)
    EXPECT_LT((relaxed[i] - parameterization[i]).norm(), 1e-9);
}

// Twice as long in both directions, every side is off by its own length: with the cotangents of the angles
// across them, the squares of a triangle's sides sum to four times its area.
TEST(Arap, TheEnergyOfAMagnifiedPlanIsFourTimesTheArea) {
  const Mesh plate = plateMesh(20, 10, 20.0, 10.0);
  std::vector<Point2> parameterization = projectionOf(plate);
  for (Point2& place : parameterization) place *= 2.0;
  EXPECT_NEAR(ArapEnergy(plate).pullOn(parameterization).energy, 800.0, 1e-9);
}

TEST(Arap, CoarseStepsComeNearTheLeastEnergy) {
  const Mesh dome = capMesh(90, 30, 20.0, 0.9);
  const ArapEnergy energy(dome);
  const std::vector<Point2> guess = projectionOf(dome);
  const double coarse = energy.pullOn(relaxCoarsely(energy, guess)).energy;
  const double exact = energy.pullOn(relaxArap(energy, guess)).energy;
  EXPECT_LT(exact, 0.5 * energy.pullOn(guess).energy);
  EXPECT_LT(coarse, 1.2 * exact);
}

}  // namespace
}  // namespace lamina
