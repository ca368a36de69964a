// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/duration_text.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(DurationText, IsRoundedOrCut) {
  EXPECT_EQ(nearestTenths(2.57), "2.6 s");
  EXPECT_EQ(fullTenths(2.57), "2.5 s");
  EXPECT_EQ(wholeSeconds(2.57), "2 s");
}

TEST(DurationText, StatesItsTenthsAlways) {
  EXPECT_EQ(nearestTenths(3.0), "3.0 s");
  EXPECT_EQ(fullTenths(3.0), "3.0 s");
}

}  // namespace
}  // namespace lamina
