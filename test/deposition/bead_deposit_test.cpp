// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/bead_deposit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

constexpr double kCell = 0.05;

BeadDeposit flatBed(double side_mm = 20.0, double cell_mm = kCell) {
  return BeadDeposit(HeightMap(heightGrid({Point2::Zero(), Point2(side_mm, side_mm)}, cell_mm), 0.0));
}

DepositedMotion motion(const Point3& start, const Point3& end, const Bead& bead) {
  return {start, end, (end - start).norm() * crossSection(bead)};
}

/// Known width of the bead across x = 10 that is higher than `height`.
double widthAbove(const HeightMap& map, double height) {
  double width = 0.0;
  for (double y = 0.5 * kCell; y < 20.0; y += kCell) width += map.nearest({10.0, y}) > height ? kCell : 0.0;
  return width;
}

TEST(BeadDeposit, ABeadReachesTheNozzleAndHasItsWidth) {
  BeadDeposit deposit = flatBed();
  deposit.lay(motion({5, 10, 0.2}, {15, 10, 0.2}, {0.4, 0.2}));
  EXPECT_NEAR(deposit.surface().nearest({10.01, 10.01}), 0.2, 1e-9);
  EXPECT_NEAR(widthAbove(deposit.surface(), 0.05), 0.4, 2.01 * kCell);
  EXPECT_DOUBLE_EQ(deposit.excessVolume(), 0.0);
}

TEST(BeadDeposit, ChoppingAMotionLeavesTheBeadAsItIs) {
  BeadDeposit whole = flatBed();
  BeadDeposit chopped = flatBed();
  whole.lay(motion({5, 10, 0.2}, {15, 10, 0.2}, {0.4, 0.2}));
  for (int i = 0; i < 300; ++i)
    chopped.lay(motion({5 + i / 30.0, 10, 0.2}, {5 + (i + 1) / 30.0, 10, 0.2}, {0.4, 0.2}));
  EXPECT_NEAR(volumeUnder(whole.surface()), volumeUnder(chopped.surface()), 1e-6);
  EXPECT_NEAR(widthAbove(whole.surface(), 0.05), widthAbove(chopped.surface(), 0.05), 2.01 * kCell);
}

TEST(BeadDeposit, TooLittleMaterialGivesALowerNarrowerBead) {
  BeadDeposit deposit = flatBed();
  // A disc of 0.2 mm under a nozzle 0.4 mm above the bed.
  deposit.lay({{5, 10, 0.4}, {15, 10, 0.4}, 10.0 * M_PI * 0.1 * 0.1});
  EXPECT_LT(deposit.surface().nearest({10.01, 10.01}), 0.21);
  EXPECT_GT(deposit.surface().nearest({10.01, 10.01}), 0.12);
  EXPECT_LT(widthAbove(deposit.surface(), 0.05), 0.3);
}

TEST(BeadDeposit, SideBySideBeadsFillAFlatLayerBelowTheNozzle) {
  BeadDeposit deposit = flatBed();
  const double spacing = crossSection({0.4, 0.2}) / 0.2;  // as much material as room
  for (int i = 0; i < 30; ++i)
    deposit.lay(motion({2, 2 + i * spacing, 0.2}, {18, 2 + i * spacing, 0.2}, {0.4, 0.2}));
  for (double y = 3.0; y < 2 + 26 * spacing; y += 0.37) {
    EXPECT_LE(deposit.surface().nearest({10.0, y}), 0.2 + 1e-12);
    EXPECT_GE(deposit.surface().nearest({10.0, y}), 0.1);
  }
}

TEST(BeadDeposit, ABeadBridgesAGapOfTheLayerBelow) {
  BeadDeposit deposit = flatBed();
  for (const double x : {5.0, 10.0, 15.0}) deposit.lay(motion({x, 5, 0.2}, {x, 15, 0.2}, {0.4, 0.2}));
  deposit.lay({{15, 15, 0.4}, {4, 10, 0.4}, 0.0});
  deposit.lay(motion({4.9, 10, 0.4}, {15.1, 10, 0.4}, {0.4, 0.2}));
  EXPECT_NEAR(deposit.surface().nearest({7.51, 10.01}), 0.4, 1e-9);
  EXPECT_NEAR(deposit.surface().nearest({7.51, 12.01}), 0.0, 1e-9);
}

TEST(BeadDeposit, MaterialWithoutRoomIsCountedAsExcess) {
  BeadDeposit deposit = flatBed();
  deposit.lay({{10, 10, 0.2}, {11, 10, 0.2}, 0.08});
  deposit.lay({{10, 10, 0.0}, {11, 10, 0.0}, 0.08});
  EXPECT_NEAR(deposit.excessVolume(), 0.08, 1e-9);
}

TEST(BeadDeposit, RefusesWhatIsNoMotion) {
  BeadDeposit deposit = flatBed();
  EXPECT_THROW(deposit.lay({{0, 0, 0}, {NAN, 0, 0}, 1.0}), InvalidInput);
  EXPECT_THROW(deposit.lay({{0, 0, 0}, {1e7, 0, 0}, 1.0}), InvalidInput);
  EXPECT_THROW(deposit.lay({{0, 0, 0}, {1, 0, 0}, -1.0}), InvalidInput);
}

TEST(BeadDeposit, ConservesVolumeOverFlatGround) {
  EXPECT_TRUE(
      rc::check("random walks of one layer gain what was extruded, less the excess", [](std::uint64_t seed) {
        Random random(seed);
        BeadDeposit deposit = flatBed(30.0, 0.1);
        Point3 nozzle(15, 15, 0.2);
        double extruded = 0.0;
        for (int i = 0; i < 12; ++i) {
          const Point3 next(random.uniform(8, 22), random.uniform(8, 22), 0.2);
          const DepositedMotion deposited = motion(nozzle, next, {random.uniform(0.2, 0.8), 0.2});
          deposit.lay(deposited);
          extruded += deposited.volume_mm3;
          nozzle = next;
        }
        const double gained = volumeUnder(deposit.surface());
        RC_ASSERT(std::abs(gained + deposit.excessVolume() - extruded) < 1e-6 * extruded);
      }));
}

}  // namespace
}  // namespace lamina
