// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/simulated_controller/arriving_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lamina {
namespace {

constexpr double kStep = 0.02;  // s

/// Ten seconds of a flow that is asked for from 1 s on.
std::vector<double> arrivedOf(const PlantSettings& plant) {
  ArrivingFlow flow(plant);
  std::vector<double> arrived;
  for (int i = 0; i <= 500; ++i) arrived.push_back(flow.at(i * kStep, i >= 50 ? 12.3 : 0.0));
  return arrived;
}

TEST(ArrivingFlow, IsWhatIsAskedForToTheLastBit) {
  ArrivingFlow flow{PlantSettings()};
  for (int i = 0; i < 100; ++i) {
    const double asked = std::sqrt(static_cast<double>(i));
    EXPECT_EQ(flow.at(i / 3.0, asked), asked);
  }
}

TEST(ArrivingFlow, ComesAfterTheDeadTimeTimesTheGain) {
  PlantSettings plant;
  plant.gain = 0.9;
  plant.dead_time_s = 2.0;
  const auto arrived = arrivedOf(plant);
  EXPECT_EQ(arrived[148], 0.0);
  EXPECT_NEAR(arrived[151], 0.9 * 12.3, 1e-12);
}

TEST(ArrivingFlow, FollowsAsALagOfFirstOrder) {
  PlantSettings plant;
  plant.lag_s = 0.5;
  const auto arrived = arrivedOf(plant);
  EXPECT_NEAR(arrived[74], 12.3 * (1.0 - std::exp(-1.0)), 0.05) << "half a second after 1 s";
  EXPECT_NEAR(arrived[500], 12.3, 1e-6);
}

}  // namespace
}  // namespace lamina
