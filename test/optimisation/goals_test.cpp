// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/goals.hpp"

namespace lamina {
namespace {

const std::vector<std::string> kGoalsNames = {"modulus_mpa", "pore_um", "time_s"};

TEST(GoalsTest, CostsAreSmallWhereResponsesAreGood) {
  const Goals goals{{{"modulus_mpa", Sense::Maximise, 1.0}, {"time_s", Sense::Minimise, 1.0}}, {}};
  EXPECT_EQ(costsOf(goals, kGoalsNames, {500.0, 300.0, 60.0}), (std::vector<double>{-500.0, 60.0}));
}

TEST(GoalsTest, ViolationIsTheDistanceFromTheIntervalsRelativeToTheirBounds) {
  const Goals goals{{{"time_s", Sense::Minimise, 1.0}},
                    {{"modulus_mpa", 10.0, 1500.0}, {"pore_um", 300.0, 700.0}}};
  EXPECT_EQ(violationOf(goals, kGoalsNames, {10.0, 700.0, 0.0}), 0.0);
  EXPECT_DOUBLE_EQ(violationOf(goals, kGoalsNames, {1800.0, 150.0, 0.0}), 0.2 + 0.5);
  EXPECT_TRUE(std::isinf(violationOf(goals, kGoalsNames, {NAN, 500.0, 0.0})));
  const Goals around_zero{{{"time_s", Sense::Minimise, 1.0}}, {{"time_s", 0.0, 0.0}}};
  EXPECT_DOUBLE_EQ(violationOf(around_zero, kGoalsNames, {0.0, 0.0, 0.25}), 0.25);
}

TEST(GoalsTest, RefusesWhatCannotBeAskedFor) {
  const Objective time{"time_s", Sense::Minimise, 1.0};
  EXPECT_NO_THROW(validate({{time}, {{"pore_um", 300.0, 700.0}}}, kGoalsNames));
  EXPECT_THROW(validate({{}, {}}, kGoalsNames), InvalidConfig);
  EXPECT_THROW(validate({{{"mass_g", Sense::Minimise, 1.0}}, {}}, kGoalsNames), InvalidConfig);
  EXPECT_THROW(validate({{{"time_s", Sense::Minimise, -1.0}}, {}}, kGoalsNames), InvalidConfig);
  EXPECT_THROW(validate({{time}, {{"pore_um", 700.0, 300.0}}}, kGoalsNames), InvalidConfig);
  EXPECT_THROW(validate({{time}, {{"pore_um", NAN, 300.0}}}, kGoalsNames), InvalidConfig);
}

}  // namespace
}  // namespace lamina
