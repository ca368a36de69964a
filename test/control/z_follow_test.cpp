// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/z_follow.hpp"

#include <gtest/gtest.h>

#include "support/control_layers.hpp"

namespace lamina {
namespace {

constexpr double kFarBelow = -1e9;  // mm: nothing is in the head's way

std::vector<double> shifts(NozzleHeight z, double error_mm, double before_mm, const NozzleRoom& room) {
  const LayerCells cells = test::straightBeads({0.0}, 30.0, 1.0);
  LoopSettings settings;
  settings.z = z;
  const LayerKnowledge known{std::vector<double>(cells.size(), error_mm),
                             std::vector<double>(cells.size(), 1.0)};
  return nozzleShift(cells, known, before_mm, room, settings);
}

TEST(ZFollow, LeavesThePlanAlone) {
  for (const double dz : shifts(NozzleHeight::Plan, 0.7, 0.0, {1.5, kFarBelow, 0.0})) EXPECT_EQ(dz, 0.0);
}

TEST(ZFollow, FollowsTheMeanOfTheLayerByAFifthALayer) {
  for (const double dz : shifts(NozzleHeight::Layer, 0.2, 0.0, {1.5, kFarBelow, 0.0}))
    EXPECT_NEAR(dz, -0.2, 1e-12);
  for (const double dz : shifts(NozzleHeight::Layer, 0.9, 0.0, {1.5, kFarBelow, 0.0}))
    EXPECT_NEAR(dz, -0.3, 1e-12);
  for (const double dz : shifts(NozzleHeight::Layer, 0.9, -0.3, {1.5, kFarBelow, 0.0}))
    EXPECT_NEAR(dz, -0.6, 1e-12);
  for (const double dz : shifts(NozzleHeight::Layer, 9.0, -1.4, {1.5, kFarBelow, 0.0}))
    EXPECT_NEAR(dz, -1.5, 1e-12);
}

TEST(ZFollow, FollowsTheSurfaceWithinALayer) {
  for (const double dz : shifts(NozzleHeight::Surface, 0.9, 0.0, {1.5, kFarBelow, 0.0}))
    EXPECT_NEAR(dz, -0.9, 1e-12);
  for (const double dz : shifts(NozzleHeight::Surface, -4.0, 0.0, {1.5, kFarBelow, 0.0})) EXPECT_EQ(dz, 1.5);
}

TEST(ZFollow, KeepsTheHeadAboveTheHighestCell) {
  // A lump 4 mm above the layer below, a head 3 mm above the nozzle: the nozzle may go down by 0.5 mm.
  for (const double dz : shifts(NozzleHeight::Surface, 0.9, 0.0, {1.5, 4.0, 3.0}))
    EXPECT_NEAR(dz, -0.5, 1e-12);
}

TEST(ZFollow, IsNoMoreThanALayerAboveAnyLump) {
  // 9 mm less 1.5 and 3 mm are 4.5 mm: more than machines take; such a lump holds the print.
  for (const double dz : shifts(NozzleHeight::Surface, 0.9, 0.0, {1.5, 9.0, 3.0})) EXPECT_EQ(dz, 1.5);
}

}  // namespace
}  // namespace lamina
