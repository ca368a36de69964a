// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/exact_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace lamina {
namespace {

TEST(ExactText, IsAsShortAsTheNumberAllows) {
  EXPECT_EQ(exactText(0.1), "0.1");
  EXPECT_EQ(exactText(-3.0), "-3");
  EXPECT_EQ(exactText(1e-7), "1e-07");
  EXPECT_EQ(exactText(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(exactText(std::numeric_limits<double>::infinity()), "inf");
}

TEST(ExactText, GivesTheNumberBack) {
  EXPECT_TRUE(rc::check("any finite number", [](double value) {
    RC_PRE(std::isfinite(value));
    RC_ASSERT(std::strtod(exactText(value).c_str(), nullptr) == value);
  }));
}

TEST(ExactText, IsAppended) {
  std::string row = "1,";
  appendExact(row, 2.5);
  EXPECT_EQ(row, "1,2.5");
}

}  // namespace
}  // namespace lamina
