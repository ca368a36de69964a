// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/number_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

namespace lamina {
namespace {

TEST(NumberText, IsNoLongerThanItsDigits) {
  EXPECT_EQ(numberText(0.2), "0.2");
  EXPECT_EQ(numberText(-3.0), "-3");
  EXPECT_EQ(numberText(0.0), "0");
  EXPECT_EQ(numberText(1.0 / 3.0), "0.333333");
  EXPECT_EQ(numberText(123456.0), "123456");
  EXPECT_EQ(numberText(1e-7), "1e-07");
  EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(numberText(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(NumberText, IsWithinSixDigitsOfTheNumber) {
  EXPECT_TRUE(rc::check("any finite number", [](double value) {
    RC_PRE(std::isfinite(value) && std::abs(value) > 1e-300 && std::abs(value) < 1e300);
    RC_ASSERT(std::abs(std::stod(numberText(value)) - value) <= 5.1e-6 * std::abs(value));
  }));
}

}  // namespace
}  // namespace lamina
