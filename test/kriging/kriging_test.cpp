// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kriging/kriging.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(KrigingTest, InterpolatesItsSamples) {
  const DesignSpace space = {{"x", VariableKind::Continuous, 0.0, 4.0, {}, {}}};
  const std::vector<DesignPoint> points = {{0.0}, {1.0}, {2.0}, {3.0}, {4.0}};
  const std::vector<double> values = {1.0, 3.0, 2.0, 5.0, 4.0};
  const auto surrogate = krigingFit({})(space, points, values);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(surrogate->at(points[i]).value, values[i], 1e-6);
    EXPECT_EQ(surrogate->at(points[i]).variance, 0.0);
  }
  EXPECT_GT(surrogate->at({0.5}).variance, 0.0);
}

}  // namespace
}  // namespace lamina
