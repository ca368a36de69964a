// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/surface_cut.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// A level square from 0 to 10 mm of 10 x 10 cells, nozzle tips 0.1 mm above it.
LayerSurface square() {
  LayerSurface surface;
  for (int j = 0; j <= 10; ++j)
    for (int i = 0; i <= 10; ++i) surface.middle.vertices.emplace_back(i, j, 0.0);
  for (std::uint32_t j = 0; j < 10; ++j)
    for (std::uint32_t i = 0; i < 10; ++i) {
      const std::uint32_t corner = 11 * j + i;
      surface.middle.triangles.push_back({corner, corner + 1, corner + 12});
      surface.middle.triangles.push_back({corner, corner + 12, corner + 11});
    }
  for (const Point3& vertex : surface.middle.vertices) {
    surface.tip.emplace_back(vertex + Point3(0.0, 0.0, 0.1));
    surface.normal.emplace_back(0.0, 0.0, 1.0);
    surface.height_mm.push_back(0.2);
  }
  return surface;
}

std::vector<double> fieldOf(const LayerSurface& surface, const Point3& slope, double at_origin) {
  std::vector<double> field;
  for (const Point3& vertex : surface.middle.vertices) field.push_back(at_origin + slope.dot(vertex));
  return field;
}

TEST(SurfaceCut, ALinearFieldCutsAlongItsZeroLine) {
  const LayerSurface surface = square();
  const LayerSurface kept = whereNotNegative(surface, fieldOf(surface, {-1.0, 0.0, 0.0}, 3.25));
  EXPECT_NEAR(surfaceArea(kept.middle), 32.5, 1e-9);
  EXPECT_NEAR(boundingBox(kept.middle).high.x(), 3.25, 1e-12);
  for (std::size_t i = 0; i < kept.tip.size(); ++i) {
    EXPECT_NEAR((kept.tip[i] - kept.middle.vertices[i] - Point3(0.0, 0.0, 0.1)).norm(), 0.0, 1e-12);
    EXPECT_DOUBLE_EQ(kept.height_mm[i], 0.2);
  }
}

TEST(SurfaceCut, ACutThroughVerticesLeavesNoSlivers) {
  const LayerSurface surface = square();
  const LayerSurface kept = whereNotNegative(surface, fieldOf(surface, {-1.0, 0.0, 0.0}, 3.0));
  EXPECT_EQ(kept.middle.triangles.size(), 60U);
  EXPECT_NEAR(surfaceArea(kept.middle), 30.0, 1e-12);
}

TEST(SurfaceCut, BothSidesOfAnyLineMakeUpTheWhole) {
  const LayerSurface surface = square();
  EXPECT_TRUE(rc::check([&] {
    const double heading = *rc::gen::inRange(0, 6283) / 1000.0;
    const Point3 slope(std::cos(heading), std::sin(heading), 0.0);
    const double distance = *rc::gen::inRange(-1500, 1500) / 100.0;
    std::vector<double> field = fieldOf(surface, slope, distance);
    double area = surfaceArea(whereNotNegative(surface, field).middle);
    for (double& value : field) value = -value;
    area += surfaceArea(whereNotNegative(surface, field).middle);
    RC_ASSERT(std::abs(area - 100.0) <= 1e-9);
  }));
}

TEST(SurfaceCut, PiecesApartAreFoundApart) {
  const LayerSurface surface = square();
  std::vector<double> field;
  for (const Point3& vertex : surface.middle.vertices) field.push_back(std::abs(vertex.x() - 5.0) - 1.5);
  const std::vector<LayerSurface> pieces = connectedPieces(whereNotNegative(surface, field));
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(surfaceArea(pieces[0].middle), 35.0, 1e-9);
  EXPECT_NEAR(surfaceArea(pieces[1].middle), 35.0, 1e-9);
}

TEST(SurfaceCut, PiecesThatTouchInAVertexAreApart) {
  const LayerSurface surface = square();
  // Two triangles on opposite sides of the vertex in row 1, column 1.
  const LayerSurface pair = pieceOf(surface, {0, 2 * 11 + 0});
  const std::vector<LayerSurface> pieces = connectedPieces(pair);
  ASSERT_EQ(pieces.size(), 2U);
  for (const LayerSurface& piece : pieces) EXPECT_EQ(piece.middle.vertices.size(), 3U);
}

TEST(SurfaceCut, FieldsThatDoNotFitAreRefused) {
  const LayerSurface surface = square();
  EXPECT_THROW(whereNotNegative(surface, {1.0}), InvalidInput);
  std::vector<double> field(121, 1.0);
  field[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(whereNotNegative(surface, field), InvalidInput);
}

}  // namespace
}  // namespace lamina
