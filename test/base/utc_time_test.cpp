// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/utc_time.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

// Times as `date -u -d TEXT +%s` states them.
TEST(UtcTime, IsStatedAsInFiles) {
  EXPECT_EQ(utcText(0), "1970-01-01T00:00:00Z");
  EXPECT_EQ(utcText(1795435200), "2026-11-23T12:00:00Z");
  EXPECT_EQ(utcText(1709164799.999), "2024-02-28T23:59:59Z");
}

TEST(UtcTime, IsStatedByAFormat) {
  EXPECT_EQ(utcText(1709164800.5, "%Y-%m-%d"), "2024-02-29");
  EXPECT_EQ(utcText(1795435200, "%Y-%m-%d %H:%M:%S UTC"), "2026-11-23 12:00:00 UTC");
}

}  // namespace
}  // namespace lamina
