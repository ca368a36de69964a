// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/taut_string.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>

namespace lamina {
namespace {

constexpr double kWide = std::numeric_limits<double>::infinity();

TEST(TautString, GoesStraightWhereNothingIsInTheWay) {
  const auto values = tautString({{0, 1, 1}, {1, -kWide, kWide}, {3, -5, 5}, {4, 3, 3}});
  EXPECT_EQ(values, (std::vector<double>{1.0, 1.5, 2.5, 3.0}));
}

TEST(TautString, BendsAboutTheEndsOfGates) {
  const auto values = tautString({{0, 0, 0}, {1, -1, 1}, {2, 2, 9}, {3, -9, 1}, {4, 0, 0}});
  EXPECT_EQ(values, (std::vector<double>{0.0, 1.0, 2.0, 1.0, 0.0}));
}

TEST(TautString, OfOneGateIsThatGate) {
  EXPECT_EQ(tautString({{0, 2, 2}}), std::vector<double>{2.0});
  EXPECT_TRUE(tautString({}).empty());
}

TEST(TautString, PassesEveryGateAndBendsOnlyWhereOneHoldsIt) {
  EXPECT_TRUE(rc::check([] {
    const int count = *rc::gen::inRange(2, 40);
    std::vector<Gate> gates;
    for (int i = 0; i < count; ++i) {
      const double middle = *rc::gen::inRange(-100, 101);
      const double half = i == 0 || i + 1 == count ? 0.0 : *rc::gen::inRange(0, 60);
      gates.push_back({static_cast<double>(i), middle - half, middle + half});
    }
    const std::vector<double> values = tautString(gates);
    for (std::size_t i = 0; i < values.size(); ++i) {
      RC_ASSERT(values[i] >= gates[i].low - 1e-9 && values[i] <= gates[i].high + 1e-9);
      if (i == 0 || i + 1 == values.size()) continue;
      // It bends upwards about a high end, downwards about a low one.
      const double bend = values[i - 1] - 2.0 * values[i] + values[i + 1];
      if (bend > 1e-9) RC_ASSERT(values[i] >= gates[i].high - 1e-9);
      if (bend < -1e-9) RC_ASSERT(values[i] <= gates[i].low + 1e-9);
    }
  }));
}

}  // namespace
}  // namespace lamina
