// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/drop_overlap.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

TEST(DropOverlap, HasTheValuesOfBothDefinitions) {
  const double distance[] = {1.0, 0.9, 0.8, 0.5, 0.0};
  const double linear[] = {0.0, 0.1, 0.2, 0.5, 1.0};
  const double area[] = {0.0, 0.03739, 0.10409, 0.39100, 1.0};
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(overlapAt(distance[i], OverlapDefinition::Linear), linear[i], 1e-12);
    EXPECT_NEAR(overlapAt(distance[i], OverlapDefinition::Area), area[i], 1e-5);
  }
}

TEST(DropOverlap, OfDropsApartIsNone) {
  EXPECT_EQ(overlapAt(1.7, OverlapDefinition::Linear), 0.0);
  EXPECT_EQ(overlapAt(1.7, OverlapDefinition::Area), 0.0);
}

TEST(DistanceOfOverlap, HasTheValuesOfBothDefinitions) {
  const double overlap[] = {0.0, 0.05, 0.1, 0.2, 0.3, 0.5};
  const double linear[] = {1.0, 0.95, 0.9, 0.8, 0.7, 0.5};
  const double area[] = {1.0, 0.8783, 0.8054, 0.6870, 0.5851, 0.4040};
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(distanceOfOverlap(overlap[i], OverlapDefinition::Linear), linear[i], 1e-12);
    EXPECT_NEAR(distanceOfOverlap(overlap[i], OverlapDefinition::Area), area[i], 5e-5);
  }
}

TEST(DistanceOfOverlap, RefusesWhatIsNoShare) {
  EXPECT_THROW(distanceOfOverlap(-0.1, OverlapDefinition::Linear), InvalidInput);
  EXPECT_THROW(distanceOfOverlap(1.1, OverlapDefinition::Area), InvalidInput);
}

}  // namespace
}  // namespace lamina
