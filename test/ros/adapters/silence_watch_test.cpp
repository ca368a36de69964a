// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/layer_height_monitor/silence_watch.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

/// Looks ten times a second.
bool isSilentAfter(SilenceWatch& watch, int looks, double from_s) {
  bool is_silent = false;
  for (int i = 0; i < looks; ++i) is_silent = watch.look(7, from_s + 0.1 * i);
  return is_silent;
}

TEST(SilenceWatch, NoticesThatNothingComes) {
  SilenceWatch watch(2.05);
  EXPECT_FALSE(isSilentAfter(watch, 21, 100.0)) << "2 s since the first look";
  EXPECT_TRUE(isSilentAfter(watch, 1, 102.1));
}

TEST(SilenceWatch, StartsAgainWithAnythingThatComes) {
  SilenceWatch watch(2.05);
  isSilentAfter(watch, 21, 100.0);
  EXPECT_FALSE(watch.look(8, 102.1));
  EXPECT_FALSE(watch.look(8, 102.2));
}

TEST(SilenceWatch, TakesTimeInWhichNobodyLookedForNoSilence) {
  SilenceWatch watch(2.05);
  watch.look(7, 100.0);
  EXPECT_FALSE(watch.look(7, 160.0)) << "the node did not run for a minute";
}

TEST(SilenceWatch, OfNoLengthIsNeverNoticed) {
  SilenceWatch watch(0.0);
  EXPECT_FALSE(isSilentAfter(watch, 1000, 100.0));
}

}  // namespace
}  // namespace lamina
