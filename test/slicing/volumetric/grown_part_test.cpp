// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/grown_part.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

constexpr double kLayerMm = 0.25;

// 8 mm2 in a layer of 0.25 mm are 2 mm3.
TEST(GrownPart, LosesNoMoreVolumeThanALayerOverTheSurfaceThatIsSupportedInstead) {
  const GrowthLoss best{20.0, 1.0};
  EXPECT_TRUE(supportsMore({12.0, 1.0}, best, kLayerMm));
  EXPECT_TRUE(supportsMore({12.0, 3.0}, best, kLayerMm));
  EXPECT_FALSE(supportsMore({12.0, 3.01}, best, kLayerMm));
}

TEST(GrownPart, IsNoBetterWhereNoMoreIsSupported) {
  const GrowthLoss best{20.0, 1.0};
  EXPECT_FALSE(supportsMore(best, best, kLayerMm));
  EXPECT_FALSE(supportsMore({20.0, 0.0}, best, kLayerMm));
  EXPECT_FALSE(supportsMore({21.0, 0.0}, best, kLayerMm));
}

// What is no longer lost counts for what is supported besides.
TEST(GrownPart, IsBetterWhereMoreIsSupportedAndLessIsLost) {
  EXPECT_TRUE(supportsMore({19.9, 0.0}, {20.0, 1.0}, kLayerMm));
}

}  // namespace
}  // namespace lamina
