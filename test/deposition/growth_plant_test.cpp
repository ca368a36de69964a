// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/growth_plant.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

PlantBead straightBead(std::size_t cells, double length_mm) {
  PlantBead bead;
  bead.length_mm = length_mm;
  bead.layers = 10;
  for (std::size_t i = 0; i < cells; ++i)
    bead.along_mm.push_back((static_cast<double>(i) + 0.5) * length_mm / static_cast<double>(cells));
  bead.planned_mm.assign(cells, 1.5);
  bead.correction.assign(cells, 0.0);
  bead.nozzle_far_mm.assign(cells, 0.0);
  return bead;
}

TEST(GrowthPlant, WithoutDisturbancesLaysWhatIsCommandedToTheLastBit) {
  PlantBead bead = straightBead(50, 25.0);
  std::vector<double> heights;
  for (std::size_t i = 0; i < 50; ++i) {
    bead.correction[i] = 0.013 * static_cast<double>(i);
    bead.nozzle_far_mm[i] = 0.1 * static_cast<double>(i);
    heights.push_back(std::sqrt(static_cast<double>(i)));
  }
  bead.layer = 7;
  bead.layer_s = 20.0;
  const auto after = GrowthPlant(PlantSettings()).afterBead(bead, heights);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(after[i], heights[i] + 1.5 * (1.0 + bead.correction[i]));
  EXPECT_EQ(delayed({bead.along_mm, bead.correction}, bead.along_mm, PlantSettings()), bead.correction);
}

TEST(GrowthPlant, LosesGrowthAtEndsAndByWear) {
  PlantSettings settings;
  settings.gain = 0.9;
  settings.end_loss = 0.2;
  settings.end_mm = 10.0;
  settings.wear = 0.5;
  const GrowthPlant plant(settings);
  PlantBead bead = straightBead(100, 100.0);
  EXPECT_DOUBLE_EQ(plant.gainAt(bead, 50.0), 0.9);
  EXPECT_NEAR(plant.gainAt(bead, 0.0), 0.72, 1e-12);
  EXPECT_NEAR(plant.gainAt(bead, 95.0), 0.81, 1e-12);
  bead.layer = 5;
  EXPECT_NEAR(plant.gainAt(bead, 50.0), 0.9 * 0.75, 1e-12);
  bead.is_closed = true;
  EXPECT_NEAR(plant.gainAt(bead, 0.0), 0.9 * 0.75, 1e-12);
}

TEST(GrowthPlant, ClogsAtItsLayer) {
  PlantSettings settings;
  settings.clog = 0.3;
  settings.clog_at_layer = 4;
  PlantBead bead = straightBead(10, 10.0);
  bead.layer = 2;
  EXPECT_EQ(GrowthPlant(settings).gainAt(bead, 5.0), 1.0);
  bead.layer = 3;
  EXPECT_EQ(GrowthPlant(settings).gainAt(bead, 5.0), 0.7);
}

TEST(GrowthPlant, LosesByStandOff) {
  PlantSettings settings;
  settings.standoff = 0.3;
  PlantBead bead = straightBead(1, 1.0);
  bead.nozzle_far_mm[0] = 0.75;  // half a layer
  EXPECT_NEAR(GrowthPlant(settings).afterBead(bead, {0.0})[0], 1.5 * 0.85, 1e-12);
}

TEST(GrowthPlant, LevelsAWaveAsAGaussianDoes) {
  PlantSettings settings;
  settings.levelling_mm = 2.0;
  PlantBead bead = straightBead(400, 200.0);
  std::vector<double> heights;
  for (const double s : bead.along_mm) heights.push_back(std::cos(2.0 * M_PI * s / 20.0));
  const auto after = GrowthPlant(settings).afterBead(bead, heights);
  const double damped = std::exp(-0.5 * std::pow(2.0 * M_PI * 2.0 / 20.0, 2));
  for (std::size_t i = 0; i < 400; ++i) EXPECT_NEAR(after[i] - 1.5, damped * heights[i], 1e-3);
}

TEST(GrowthPlant, IsRandomAsStatedAndTheSameFromASeed) {
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kPlaces = 4000;
  for (int i = 0; i < kPlaces; ++i) {
    const double noise = correlatedNoise(5, 100.0 * i, 5.0);
    sum += noise / kPlaces;
    squares += noise * noise / kPlaces;
  }
  EXPECT_NEAR(sum, 0.0, 0.06);
  EXPECT_NEAR(squares, 1.0, 0.08);
  EXPECT_NEAR(correlatedNoise(5, 40.0, 5.0), correlatedNoise(5, 40.05, 5.0), 0.1) << "alike nearby";
  EXPECT_EQ(correlatedNoise(5, 40.0, 5.0), correlatedNoise(5, 40.0, 5.0));
}

TEST(GrowthPlant, LosesAPieceAtItsLayer) {
  PlantSettings settings;
  settings.detach_at_layer = 3;
  PlantBead bead = straightBead(100, 100.0);
  bead.layer = 2;
  const auto after = GrowthPlant(settings).afterBead(bead, std::vector<double>(100, 3.0));
  EXPECT_EQ(after[50], 1.5);
  EXPECT_EQ(after[34], 4.5);
  EXPECT_EQ(after[36], 1.5);
}

TEST(GrowthPlant, SettlesByTheHeatOfLayersBelow) {
  PlantSettings settings;
  settings.thermal = 0.1;
  PlantBead bead = straightBead(1, 1.0);
  bead.layer_s = 60.0;
  EXPECT_EQ(GrowthPlant(settings).afterBead(bead, {0.0})[0], 1.5) << "nothing is hot below";
  bead.layer = 1;
  const double heat = std::exp(-1.0);
  EXPECT_NEAR(GrowthPlant(settings).afterBead(bead, {0.0})[0],
              1.5 * (1.0 - 0.1 * heat * (1.0 - std::exp(-3.0))), 1e-12);
}

TEST(GrowthPlant, DelaysWhatIsCommanded) {
  PlantSettings settings;
  settings.dead_time_s = 0.5;
  std::vector<double> time_s;
  std::vector<double> commanded;
  for (int i = 0; i < 400; ++i) {
    time_s.push_back(0.01 * i);
    commanded.push_back(i < 100 ? 0.0 : 1.0);
  }
  const auto late = delayed({time_s, commanded}, time_s, settings);
  EXPECT_EQ(late[148], 0.0);
  EXPECT_EQ(late[151], 1.0);
  settings.lag_s = 0.4;
  const auto lagging = delayed({time_s, commanded}, time_s, settings);
  EXPECT_NEAR(lagging[190], 1.0 - std::exp(-1.0), 0.01);  // a time constant after the dead time
}

}  // namespace
}  // namespace lamina
