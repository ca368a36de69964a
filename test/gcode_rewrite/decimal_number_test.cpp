// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/decimal_number.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::string fixed(double value, int decimals) {
  std::string text;
  appendFixed(text, value, decimals);
  return text;
}

TEST(DecimalNumber, IsReadInEveryShapeSlicersWrite) {
  EXPECT_EQ(readDecimal("-12.5X").value, -12.5);
  EXPECT_EQ(readDecimal("+.25").value, 0.25);
  EXPECT_EQ(readDecimal("5.").length, 2U);
  EXPECT_EQ(readDecimal("1e5").length, 1U);
  EXPECT_EQ(readDecimal("-").length, 0U);
  EXPECT_EQ(readDecimal(".").length, 0U);
  EXPECT_EQ(readDecimal("").length, 0U);
}

TEST(DecimalNumber, IsTheNearestDoubleHoweverManyDigits) {
  EXPECT_TRUE(rc::check([](std::int64_t digits) {
    const int decimals = *rc::gen::inRange(0, 25);
    std::string text = std::to_string(digits);
    const std::size_t first = text[0] == '-' ? 1 : 0;
    text.insert(first, 26, '0');
    text.insert(text.size() - static_cast<std::size_t>(decimals), ".");
    const DecimalNumber number = readDecimal(text);
    RC_ASSERT(number.value == std::strtod(text.c_str(), nullptr));
    RC_ASSERT(number.length == text.size());
  }));
}

TEST(DecimalNumber, BeyondAllDoublesIsInfiniteOrNothing) {
  EXPECT_TRUE(std::isinf(readDecimal(std::string(400, '9')).value));
  EXPECT_TRUE(std::isinf(readDecimal("-" + std::string(400, '9') + ".5").value));
  EXPECT_EQ(readDecimal("0." + std::string(400, '0') + "1").value, 0.0);
}

TEST(DecimalNumber, IsWrittenAsCPrintsIt) {
  EXPECT_TRUE(rc::check([](std::int32_t thousandths) {
    const double value = thousandths * 1e-3;
    const int decimals = *rc::gen::inRange(0, 7);
    char expected[64];
    std::snprintf(expected, sizeof expected, "%.*f", decimals, value);
    const bool is_zero = std::string(expected).find_first_not_of("-0.") == std::string::npos;
    RC_ASSERT(fixed(value, decimals) == (is_zero && expected[0] == '-' ? expected + 1 : expected));
  }));
}

TEST(DecimalNumber, ThatIsTooLargeIsNotWritten) {
  EXPECT_EQ(fixed(999999999.0, 6), "999999999.000000");
  for (const double bad : {1e9, -1e9, 1e300, HUGE_VAL, std::nan("")})
    EXPECT_THROW(fixed(bad, 6), InvalidInput) << bad;
}

TEST(DecimalNumber, IsNeverMinusZero) {
  EXPECT_EQ(fixed(-0.004, 2), "0.00");
  EXPECT_EQ(fixed(-0.0, 3), "0.000");
  EXPECT_EQ(fixed(-0.5, 0), "0");
  EXPECT_EQ(fixed(-0.006, 2), "-0.01");
}

}  // namespace
}  // namespace lamina
