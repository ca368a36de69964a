// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/axis_steps.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(AxisSteps, LieWhereTheRadiusHasChangedByTheSame) {
  // The radius grows by 0.25 mm, in steps of at most 0.1 mm, then stays.
  const std::vector<AxisPoint> steps = inRadiusSteps({{{0, 0}, 0.25}, {{3, 0}, 0.5}, {{3, 7}, 0.5}}, 0.1);
  ASSERT_EQ(steps.size(), 5U);
  for (int k = 0; k <= 3; ++k) {
    EXPECT_NEAR(steps[k].point.x(), k, 1e-12);
    EXPECT_NEAR(steps[k].radius_mm, 0.25 + 0.25 / 3.0 * k, 1e-12);
  }
  EXPECT_EQ(steps[4].point, Point2(3, 7));
}

TEST(AxisSteps, LeaveASinglePointAlone) {
  const std::vector<AxisPoint> steps = inRadiusSteps({{{1, 2}, 0.3}}, 0.1);
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps[0].point, Point2(1, 2));
}

}  // namespace
}  // namespace lamina
