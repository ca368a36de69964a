// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/retraction.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(Retraction, IsBeyondTheThresholdUnlessOverInfill) {
  TravelSettings settings;
  settings.retraction_threshold_mm = 2.0;
  EXPECT_FALSE(isRetracted(2.0, TravelOver::Anything, settings));
  EXPECT_TRUE(isRetracted(2.001, TravelOver::Anything, settings));
  EXPECT_FALSE(isRetracted(30.0, TravelOver::Infill, settings));
}

TEST(Retraction, InsideThePartIsBeyondTheLongestWay) {
  TravelSettings settings;
  settings.comb_longest_mm = 30.0;
  EXPECT_FALSE(isRetractedInside(30.0, settings));
  EXPECT_TRUE(isRetractedInside(30.001, settings));
  EXPECT_FALSE(isRetracted(30.0, TravelOver::Infill, settings));
  EXPECT_TRUE(isRetracted(30.001, TravelOver::Infill, settings));
}

TEST(Retraction, OverInfillIsNeverBelowTheThreshold) {
  TravelSettings settings;
  settings.comb_longest_mm = 0.0;
  settings.retraction_threshold_mm = 2.0;
  EXPECT_FALSE(isRetracted(2.0, TravelOver::Infill, settings));
  EXPECT_TRUE(isRetracted(2.001, TravelOver::Infill, settings));
}

}  // namespace
}  // namespace lamina
