// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/decimals.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(Decimals, AreAllThere) {
  EXPECT_EQ(decimalText(1.5, 3), "1.500");
  EXPECT_EQ(decimalText(-1e-9, 3), "0.000");
  EXPECT_EQ(trimmedDecimals(0.15, 4), "0.15");
  EXPECT_EQ(trimmedDecimals(200.0, 4), "200");
}

TEST(Decimals, AreAsFewAsGiveTheNumberBack) {
  EXPECT_EQ(shortestText(0.1), "0.1");
  EXPECT_EQ(shortestText(1e-7), "0.0000001");
}

TEST(Decimals, MayBeCountedFromTheFirstDigit) {
  EXPECT_EQ(significantText(1234.56, 4), "1235");
  EXPECT_EQ(significantText(0.125, 4), "0.125");
  EXPECT_EQ(significantText(1.234e-5, 3), "1.23e-05");
}

}  // namespace
}  // namespace lamina
