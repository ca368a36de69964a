// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/lump_watch.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace lamina {
namespace {

constexpr double kNoPoint = std::numeric_limits<double>::quiet_NaN();

TEST(LumpWatch, BelievesThreeNeighboursInThreeProfiles) {
  LumpWatch watch;
  EXPECT_EQ(watch.height(), LumpWatch::kNone);
  for (int profile = 0; profile < 2; ++profile) watch.see({0.0, 6.0, 7.0, 5.0, 0.0});
  EXPECT_EQ(watch.height(), LumpWatch::kNone) << "two profiles";
  watch.see({0.0, 4.0, 7.0, 6.0, 0.0});
  EXPECT_EQ(watch.height(), 4.0) << "the least of the three";
  watch.see({0.0, 0.0, 0.0});
  EXPECT_EQ(watch.height(), 4.0);
  watch.reset();
  EXPECT_EQ(watch.height(), LumpWatch::kNone);
}

TEST(LumpWatch, BelievesNoSpray) {
  LumpWatch watch;
  for (int profile = 0; profile < 9; ++profile) watch.see({0.0, 9.0, 0.0, 9.0, 9.0, kNoPoint, 9.0, 0.0});
  EXPECT_LE(watch.height(), 0.0);
  LumpWatch alone;
  alone.see({0.0, 0.0, 0.0});
  alone.see({9.0, 9.0, 9.0});
  alone.see({0.0, 0.0, 0.0});
  EXPECT_EQ(alone.height(), 0.0) << "a single profile";
  LumpWatch narrow;
  for (int profile = 0; profile < 3; ++profile) narrow.see({9.0, 9.0});
  EXPECT_EQ(narrow.height(), LumpWatch::kNone) << "two points are no three";
}

}  // namespace
}  // namespace lamina
