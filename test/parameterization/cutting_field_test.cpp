// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/cutting_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lamina/parameterization/surface_cut.hpp"
#include "support/surfaces.hpp"

namespace lamina {
namespace {

using namespace test;

/// Area of the part where the field is positive, as a share of the whole.
double positiveShare(const Mesh& mesh, const std::vector<double>& field) {
  return surfaceArea(whereNotNegative(layerOf(mesh), field).middle) / surfaceArea(mesh);
}

TEST(CuttingField, HalvesALongPieceAcross) {
  const Mesh plate = plateMesh(40, 10, 40.0, 10.0);
  const std::vector<double> field = cuttingField(plate);
  EXPECT_NEAR(positiveShare(plate, field), 0.5, 0.05);
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (std::abs(plate.vertices[i].x() - 20.0) < 6.0) continue;
    const bool is_left = plate.vertices[i].x() < 20.0;
    EXPECT_EQ(field[i] > 0.0, is_left ? field[0] > 0.0 : field[0] < 0.0);
  }
}

TEST(CuttingField, HalvesATubeAlong) {
  const Mesh tube = band(40, 40, [](double u, double v) {
    return Point3(5.0 * std::cos(2.0 * M_PI * u), 5.0 * std::sin(2.0 * M_PI * u), 60.0 * v);
  });
  const std::vector<double> field = cuttingField(tube);
  EXPECT_NEAR(positiveShare(tube, field), 0.5, 0.05);
  const LayerSurface half = whereNotNegative(layerOf(tube), field);
  EXPECT_NEAR(boundingBox(half.middle).size().z(), 60.0, 1e-9);
}

TEST(CuttingField, RunsThroughAnApex) {
  // Of a cone around which an odd number of triangles stands: no line midway between two of its rim meets it.
  const Mesh cone = coneMesh(31, 10, 10.0);
  EXPECT_EQ(cuttingField(cone)[0], 0.0);
}

TEST(CuttingField, LiesOnNoWholeTriangle) {
  for (const Mesh& mesh : {plateMesh(12, 12, 12.0, 12.0), capMesh(24, 8, 10.0, 1.5), coneMesh(24, 8, 10.0)}) {
    const std::vector<double> field = cuttingField(mesh);
    for (const Triangle& corner : mesh.triangles)
      EXPECT_TRUE(
          std::any_of(corner.begin(), corner.end(), [&](std::uint32_t v) { return field[v] != 0.0; }));
  }
}

}  // namespace
}  // namespace lamina
