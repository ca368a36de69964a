// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/height_field/height_field.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <cmath>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

/// A grid of 4 x 3 cells of 2 mm whose factors are given by `factor(x, y)`.
template <class Factor>
HeightField fieldOf(Factor factor) {
  HeightField field{{{-1.0, 2.0}, 2.0, 4, 3}, 0.5, {}};
  for (int row = 0; row <= 3; ++row)
    for (int column = 0; column <= 4; ++column) {
      const Point2 at = field.cornerPoint(column, row);
      field.factor.push_back(factor(at.x(), at.y()));
    }
  return field;
}

TEST(HeightField, IsLinearBetweenItsCorners) {
  const HeightField field = fieldOf([](double x, double y) { return 1.0 + 0.03 * x - 0.02 * y; });
  EXPECT_TRUE(rc::check([&] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Point2 at(random.uniform(-1.0, 7.0), random.uniform(2.0, 8.0));
    RC_ASSERT(std::abs(field.factorAt(at) - (1.0 + 0.03 * at.x() - 0.02 * at.y())) < 1e-12);
  }));
}

TEST(HeightField, IsBeyondItsGridWhatItIsAtTheBorder) {
  const HeightField field = fieldOf([](double x, double) { return 1.0 + 0.1 * x; });
  EXPECT_NEAR(field.factorAt({-50.0, 3.0}), 0.9, 1e-12);
  EXPECT_NEAR(field.factorAt({50.0, 30.0}), 1.7, 1e-12);
}

TEST(HeightField, LevelsWhatItBends) {
  Random factors(7);
  const HeightField field = fieldOf([&](double, double) { return factors.uniform(0.5, 1.5); });
  EXPECT_TRUE(rc::check([&] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Point3 point(random.uniform(-2.0, 8.0), random.uniform(1.0, 9.0), random.uniform(0.5, 50.0));
    RC_ASSERT((field.level(field.bent(point)) - point).norm() < 1e-12 * 100.0);
    RC_ASSERT(field.bent({point.x(), point.y(), 0.5}).z() == 0.5);
  }));
}

TEST(HeightField, MakesALayerWhoseTrianglesHoldItsVolume) {
  const HeightField field = fieldOf([](double x, double y) { return 1.0 + 0.02 * x + 0.01 * y; });
  const LayerBounds bounds{10.4, 10.6};
  const LayerChart chart = bentLayer(field, bounds, {{0.0, 3.0}, {5.0, 7.0}});
  double volume = 0.0;
  double expected = 0.0;
  for (const Triangle& triangle : chart.surface.middle.triangles) {
    const auto& at = chart.surface.middle.vertices;
    double height = 0.0;
    double factor = 0.0;
    for (const std::uint32_t corner : triangle) {
      height += chart.surface.height_mm[corner] / 3.0;
      factor += field.factorAt(chart.parameterization[corner]) / 3.0;
    }
    volume +=
        0.5 * (at[triangle[1]] - at[triangle[0]]).cross(at[triangle[2]] - at[triangle[0]]).norm() * height;
    expected += 2.0 * bounds.height() * factor;  // half a cell of 4 mm²
  }
  EXPECT_NEAR(volume / expected, 1.0, 1e-9);
}

TEST(HeightField, CoversTheAreaAskedForByWholeCells) {
  const HeightField field = fieldOf([](double, double) { return 1.0; });
  const LayerChart chart = bentLayer(field, {10.4, 10.6}, {{0.0, 3.0}, {2.5, 3.5}});
  EXPECT_EQ(chart.surface.middle.triangles.size(), 4U);
  EXPECT_EQ(chart.parameterization.front(), Point2(-1.0, 2.0));
  EXPECT_EQ(chart.parameterization.back(), Point2(3.0, 4.0));
  for (const Point3& tip : chart.surface.tip) EXPECT_EQ(tip.z(), 10.6);
}

}  // namespace
}  // namespace lamina
