// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/grown_deposit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kLayer = 1.5;
constexpr double kWidth = 3.0;
constexpr double kLength = 60.0;
constexpr double kSpeed = 10.0;  // mm/s
constexpr double kX = 10.0;      // where the wall begins, in x and y

HeightMap bed() { return HeightMap(heightGrid({Point2(0, 0), Point2(80, 40)}, 0.25), 0.0); }

/// A wall along x of one bead per layer, printed to and fro; each layer has its amount over the planned one.
class Wall {
 public:
  explicit Wall(const PlantSettings& plant, const GrownDepositSettings& settings = {})
      : deposit_(bed(), plant, settings) {}

  void layLayer(double amount, double dz_mm = 0.0) {
    ++layer_;
    const double z = kLayer * layer_ + dz_mm;
    const bool is_back = layer_ % 2 == 0;
    constexpr int kPieces = 12;
    for (int i = 0; i < kPieces; ++i) {
      const double from = kLength * i / kPieces;
      const double to = kLength * (i + 1) / kPieces;
      const double start_s = now_s_;
      now_s_ += (to - from) / kSpeed;
      deposit_.lay({{placeOf(from, is_back), kX, z},
                    {placeOf(to, is_back), kX, z},
                    amount * kWidth * kLayer * (to - from),
                    start_s,
                    now_s_});
    }
    deposit_.endBead();
    now_s_ += 5.0;
  }
  double at(double along_mm, double across_mm = 0.1) const {
    return deposit_.surface().nearest(Point2(kX + along_mm, kX + across_mm));
  }
  const GrownDeposit& deposit() const { return deposit_; }

 private:
  static double placeOf(double along, bool is_back) { return kX + (is_back ? kLength - along : along); }

  GrownDeposit deposit_;
  int layer_ = 0;
  double now_s_ = 0.0;
};

TEST(GrownDeposit, GrowsByVolumeOverWidthWhateverTheNozzleDoes) {
  Wall wall{PlantSettings()};
  for (int k = 0; k < 4; ++k) wall.layLayer(1.0);
  EXPECT_NEAR(wall.at(30.0), 4 * kLayer, 1e-9);
  wall.layLayer(1.2);
  EXPECT_NEAR(wall.at(30.0), 5.2 * kLayer, 1e-9) << "nothing holds the bead down";
  EXPECT_NEAR(wall.at(30.0, 0.5 * kWidth - 0.2), 5.2 * kLayer, 1e-9);
  EXPECT_EQ(wall.at(30.0, 0.5 * kWidth + 0.3), 0.0);
  EXPECT_EQ(wall.at(-0.3), 0.0) << "beside its end nothing is deposited";
  EXPECT_NEAR(volumeUnder(wall.deposit().surface()), 5.2 * kLayer * kWidth * kLength, 1e-3 * 1400);
}

TEST(GrownDeposit, AddsUpAGainThatIsTooSmall) {
  PlantSettings plant;
  plant.gain = 0.9;
  Wall wall(plant);
  for (int k = 0; k < 10; ++k) wall.layLayer(1.0);
  EXPECT_NEAR(wall.at(30.0), 0.9 * 10 * kLayer, 1e-9);
}

TEST(GrownDeposit, IsLowAtEnds) {
  PlantSettings plant;
  plant.end_loss = 0.2;
  plant.end_mm = 10.0;
  Wall wall(plant);
  wall.layLayer(1.0);
  EXPECT_NEAR(wall.at(30.0), kLayer, 1e-9);
  EXPECT_NEAR(wall.at(0.3), kLayer * (1.0 - 0.2 * 0.975), 1e-9) << "of the first half millimetre";
  EXPECT_NEAR(wall.at(5.3), kLayer * (1.0 - 0.2 * 0.475), 1e-9);
}

TEST(GrownDeposit, HearsTheFeederLate) {
  PlantSettings plant;
  plant.dead_time_s = 2.0;
  Wall wall(plant);
  wall.layLayer(1.0);
  wall.layLayer(1.4);  // comes back from the far end
  EXPECT_NEAR(wall.at(50.0), 2.0 * kLayer, 1e-9) << "the first 20 mm at 10 mm/s";
  EXPECT_NEAR(wall.at(30.0), 2.4 * kLayer, 1e-9);
}

TEST(GrownDeposit, WearsOverItsLayersAndLosesByStandOff) {
  PlantSettings plant;
  plant.wear = 0.5;
  GrownDepositSettings settings;
  settings.layers = 2;
  Wall wall(plant, settings);
  wall.layLayer(1.0);
  wall.layLayer(1.0);
  EXPECT_NEAR(wall.at(30.0), kLayer * (1.0 + 0.75), 1e-9);

  PlantSettings far;
  far.standoff = 0.3;
  Wall high(far);
  high.layLayer(1.0);
  high.layLayer(1.0, 0.5);
  EXPECT_NEAR(high.at(30.0), kLayer + kLayer * (1.0 - 0.3 * 0.5 / kLayer), 1e-9);
}

TEST(GrownDeposit, LiesBesideItsPlaceAndHasTheWidthGivenIt) {
  PlantSettings plant;
  plant.nozzle_offset_mm = {0.0, 1.0, 0.0};
  GrownDepositSettings settings;
  settings.bead_width_mm = 6.0;
  Wall wall(plant, settings);
  wall.layLayer(1.0);
  EXPECT_NEAR(wall.at(30.0, 3.8), 0.5 * kLayer, 1e-9);
  EXPECT_EQ(wall.at(30.0, 4.2), 0.0);
  EXPECT_NEAR(wall.at(30.0, -1.9), 0.5 * kLayer, 1e-9);
  EXPECT_EQ(wall.at(30.0, -2.2), 0.0);
}

TEST(GrownDeposit, JoinsAClosedBead) {
  PlantSettings plant;
  plant.end_loss = 0.5;
  GrownDeposit deposit(bed(), plant, {});
  const Point3 corners[] = {{10, 10, kLayer}, {40, 10, kLayer}, {40, 30, kLayer}, {10, 30, kLayer}};
  for (int i = 0; i < 4; ++i) {
    const Point3& from = corners[i];
    const Point3& to = corners[(i + 1) % 4];
    deposit.lay({from, to, kWidth * kLayer * (to - from).norm(), 0.0, 1.0});
  }
  EXPECT_EQ(deposit.highest(), 0.0) << "a bead stands once it has ended";
  deposit.endBead();
  for (const Point2& at : {Point2(10.1, 10.1), Point2(25.1, 10.1), Point2(39.9, 29.9), Point2(10.1, 20.1)})
    EXPECT_NEAR(deposit.surface().nearest(at), kLayer, 1e-9) << at.transpose();
}

TEST(GrownDeposit, OfALeaningWallReachesOutOverTheBeadBelow) {
  PlantSettings plant;
  plant.gain = 0.9;
  GrownDeposit deposit(bed(), plant, {});
  for (int layer = 1; layer <= 8; ++layer) {
    const double y = 10.0 + 0.7 * layer;
    const double z = kLayer * layer;
    deposit.lay({{10, y, z}, {70, y, z}, kWidth * kLayer * 60.0, 10.0 * layer, 10.0 * layer + 6.0});
    deposit.endBead();
  }
  for (const double across : {-1.3, 0.1, 1.3})
    EXPECT_NEAR(deposit.surface().nearest(Point2(40.1, 10.0 + 0.7 * 8 + across)), 0.9 * 8 * kLayer, 1e-9);
  EXPECT_NEAR(deposit.surface().nearest(Point2(40.1, 9.4)), 0.9 * kLayer, 1e-9) << "of the first bead alone";
}

/// Of a stadium of 3 x 1.5 mm a fifth less is as high, and narrower by a fifth of its section over its
/// height.
/// A bed at 45 deg, as it is along a tool axis that leans: as much lower as farther along y from 10 mm.
HeightMap slope() {
  HeightMap ground = bed();
  for (std::size_t cell = 0; cell < ground.grid().cellCount(); ++cell)
    ground.set(cell, kX - ground.grid().centre(cell).y());
  return ground;
}

/// A wall over the slope whose beads, of a stadium's section, lie as much farther along y from layer to
/// layer.
class WallOnSlope {
 public:
  WallOnSlope(double first_y, double each_y, const GrownDepositSettings& settings = {})
      : deposit_(slope(), PlantSettings(), settings), first_y_(first_y), each_y_(each_y) {}

  void layLayers(int layers) {
    constexpr double kSection = (kWidth - kLayer) * kLayer + 0.25 * M_PI * kLayer * kLayer;
    for (int i = 0; i < layers; ++i) {
      const double y = first_y_ + each_y_ * layer_;
      const double z = kLayer * ++layer_;
      deposit_.lay({{kX, y, z}, {kX + kLength, y, z}, kSection * kLength, 0.0, 1.0});
      deposit_.endBead();
    }
  }
  double topOfLast() const {
    return deposit_.surface().nearest(Point2(kX + 30.0, first_y_ + each_y_ * (layer_ - 1)));
  }
  const GrownDeposit& deposit() const { return deposit_; }

 private:
  GrownDeposit deposit_;
  double first_y_, each_y_;
  int layer_ = 0;
};

/// The first nozzle is 1.5 or 3 mm over the bed there: layers are 1.5 mm high all the same.
TEST(GrownDeposit, OverASlopeLayersAreAsHighAsTheNozzleRises) {
  WallOnSlope stacked(kX, 0.0);
  WallOnSlope upright(kX + 1.5, 1.5);
  for (int k = 1; k <= 8; ++k) {
    stacked.layLayers(1);
    upright.layLayers(1);
    EXPECT_NEAR(stacked.topOfLast(), kLayer * k, 1e-9) << "on a bed that is 0 in its mean";
    EXPECT_NEAR(upright.topOfLast(), kLayer * k, 1e-9) << "on a bed that is -1.5 mm in its mean";
  }
}

/// Of a bead as sliced, whose contour is cut halfway up, the nozzle is 2.25 mm from the bed; of one whose
/// edge is at its lower side 3 mm. The bed is 1.875 mm below one farther down the slope: at the edge of a
/// square section as high as a layer, 2.68 mm wide.
TEST(GrownDeposit, OverASlopeAFirstBeadHangsOnItsFoot) {
  for (const double nozzle_mm : {1.5, 2.25, 3.0}) {
    WallOnSlope wall(kX + nozzle_mm - kLayer, 0.0);
    wall.layLayers(1);
    EXPECT_NEAR(wall.topOfLast(), kLayer, 1e-9) << nozzle_mm << " mm from the bed";
  }
  WallOnSlope fallen(kX + 3.0, 0.0);
  fallen.layLayers(1);
  EXPECT_NEAR(fallen.topOfLast(), kLayer - 1.875, 1e-9) << "on the highest cell under it";
  WallOnSlope buried(kX - 1.0, 0.0);
  buried.layLayers(1);
  EXPECT_NEAR(buried.topOfLast(), kLayer + 1.0, 1e-9) << "on the mean of a bed that is above its underside";
}

/// As wide as stated, beads are as high as their section asks for, from the first layer on.
TEST(GrownDeposit, OverASlopeAWidthThatIsStatedSaysHowHighLayersAre) {
  constexpr double kAsWide = 2.0;
  GrownDepositSettings settings;
  settings.bead_width_mm = kAsWide;
  WallOnSlope wall(kX, 0.0, settings);
  wall.layLayers(5);
  EXPECT_NEAR(wall.topOfLast(), 5.0 * ((kWidth - kLayer) * kLayer + 0.25 * M_PI * kLayer * kLayer) / kAsWide,
              1e-9);
  EXPECT_NEAR(wall.deposit().surface().nearest(Point2(40.0, kX + 1.1)), -1.125, 1e-9) << "the bed beside it";
}

/// A bead that is too low for the bed beside its middle does not dig into it.
TEST(GrownDeposit, OverASlopeTheBedStays) {
  GrownDepositSettings settings;
  settings.bead_width_mm = 6.0;
  WallOnSlope wall(kX, 0.0, settings);
  wall.layLayers(1);
  EXPECT_NEAR(wall.deposit().surface().nearest(Point2(40.0, kX - 2.9)), 2.875, 1e-9);
}

TEST(GrownDeposit, OfAPressedProcessIsAsHighAsTheNozzleAndNarrower) {
  const double section = kLayer * (kWidth - kLayer) + 0.25 * M_PI * kLayer * kLayer;
  const double half_width = 0.5 * (kWidth - 0.2 * section / kLayer);  // 1.232
  PlantSettings plant;
  plant.pressed = true;
  plant.gain = 0.8;
  GrownDeposit deposit(bed(), plant, {kWidth});
  for (int layer = 1; layer <= 2; ++layer) {
    const double z = kLayer * layer;
    deposit.lay({{10, 20, z}, {70, 20, z}, section * 60.0, 10.0 * layer, 10.0 * layer + 6.0});
    deposit.endBead();
  }
  const auto at = [&](double across) { return deposit.surface().nearest(Point2(40.1, 20.0 + across)); };
  EXPECT_NEAR(at(0.1), 2.0 * kLayer, 1e-9);
  EXPECT_NEAR(at(-0.1), 2.0 * kLayer, 1e-9);
  EXPECT_EQ(at(half_width + 0.15), 0.0);
  EXPECT_GT(at(half_width - 0.15), kLayer);
}

/// What heat is left after ten seconds lets the second layer settle.
/// Filament on cells a quarter as wide: the ground is found wherever its middle lies among them.
TEST(GrownDeposit, OfAPressedProcessFindsTheGroundOfNarrowBeads) {
  PlantSettings plant;
  plant.pressed = true;
  plant.gain = 0.85;
  for (int i = 0; i < 10; ++i) {
    GrownDeposit deposit(HeightMap(heightGrid({Point2(0, 0), Point2(20, 4)}, 0.1), 0.0), plant, {});
    const double y = 2.0 + 0.01 * i;
    for (int layer = 1; layer <= 4; ++layer) {
      const double z = 0.2 * layer;
      deposit.lay({{2, y, z}, {18, y, z}, 0.0714 * 16.0, 0.0, 1.0});
      deposit.endBead();
    }
    EXPECT_NEAR(deposit.surface().nearest(Point2(10, y)), 0.8, 0.01) << y;
  }
}

TEST(GrownDeposit, OfAPressedProcessSettles) {
  PlantSettings plant;
  plant.pressed = true;
  plant.thermal = 0.1;
  plant.z_error_mm = 0.2;
  GrownDeposit deposit(bed(), plant, {kWidth});
  for (int layer = 1; layer <= 2; ++layer) {
    const double z = kLayer * layer;
    deposit.lay({{10, 20, z}, {70, 20, z}, 2.0 * kWidth * kLayer * 60.0, 10.0 * layer, 10.0 * layer + 6.0});
    deposit.endBead();
  }
  const double settled = 0.1 * std::exp(-10.0 / 60.0) * (1.0 - std::exp(-10.0 / 20.0)) * kLayer;
  EXPECT_NEAR(deposit.surface().nearest(Point2(40.1, 20.1)), 2.0 * kLayer + 0.2 - settled, 1e-9);
}

TEST(GrownDeposit, AddsUpWhereBeadsOfALayerCross) {
  GrownDeposit deposit(bed(), PlantSettings(), {});
  deposit.lay({{10, 20, kLayer}, {70, 20, kLayer}, kWidth * kLayer * 60.0, 0.0, 6.0});
  deposit.endBead();
  deposit.lay({{40, 5, kLayer}, {40, 35, kLayer}, kWidth * kLayer * 30.0, 7.0, 10.0});
  deposit.endBead();
  EXPECT_NEAR(deposit.surface().nearest(Point2(40.1, 20.1)), 2 * kLayer, 1e-9);
  EXPECT_NEAR(deposit.surface().nearest(Point2(40.1, 10.1)), kLayer, 1e-9);
  EXPECT_NEAR(deposit.surface().nearest(Point2(20.1, 20.1)), kLayer, 1e-9);
}

TEST(GrownDeposit, RefusesWhatIsNoPiece) {
  GrownDeposit deposit(bed(), PlantSettings(), {});
  EXPECT_THROW(deposit.lay({{0, 0, 1}, {1, 0, 1}, -1.0, 0.0, 1.0}), InvalidInput);
  EXPECT_THROW(deposit.lay({{0, 0, 1}, {std::nan(""), 0, 1}, 1.0, 0.0, 1.0}), InvalidInput);
  deposit.lay({{0, 0, 1}, {0, 0, 1}, 1.0, 0.0, 1.0});
  deposit.endBead();
  EXPECT_EQ(deposit.highest(), 0.0);
}

TEST(GrownDeposit, IsDisturbedByAnyOfThePlant) {
  EXPECT_FALSE(isDisturbed(PlantSettings()));
  PlantSettings lengths_alone;
  lengths_alone.end_mm = 5.0;
  lengths_alone.clog_at_layer = 4;
  lengths_alone.nozzle_offset_mm = {0.0, 0.0, 0.0};
  EXPECT_FALSE(isDisturbed(lengths_alone)) << "of which nothing follows";
  PlantSettings gain;
  gain.gain = 0.9;
  EXPECT_TRUE(isDisturbed(gain));
}

}  // namespace
}  // namespace lamina
