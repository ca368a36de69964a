// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/path_low_pass.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

Stations equalStations(int count, double length_mm, PathEnds ends) {
  Stations stations{{}, length_mm, ends};
  for (int i = 0; i < count; ++i) stations.along_mm.push_back((i + 0.5) * length_mm / count);
  return stations;
}

std::vector<double> cosine(const Stations& stations, double wave_mm) {
  std::vector<double> values;
  for (const double s : stations.along_mm) values.push_back(std::cos(2.0 * M_PI * s / wave_mm));
  return values;
}

/// A Gaussian damps a wave to exp(-(2 pi sigma / wave)^2 / 2); a cosine with its crests at the ends is its
/// own reflection.
TEST(PathLowPass, DampsAWaveAsAGaussianDoes) {
  const double sigma = 3.0;
  for (const PathEnds ends : {PathEnds::Reflected, PathEnds::Joined}) {
    const Stations stations = equalStations(400, 200.0, ends);
    const double wave = 20.0;
    const double damped = std::exp(-0.5 * std::pow(2.0 * M_PI * sigma / wave, 2));
    const auto values = cosine(stations, wave);
    const auto smooth = lowPassed(values, stations, sigma);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(smooth[i], damped * values[i], 2e-4);
  }
}

TEST(PathLowPass, TakesUnequalStations) {
  Stations stations{{}, 100.0, PathEnds::Reflected};
  for (double s = 0.1; s < 100.0; s += 0.2 + 0.3 * std::abs(std::sin(s))) stations.along_mm.push_back(s);
  const auto values = cosine(stations, 25.0);
  const auto smooth = lowPassed(values, stations, 2.0);
  const double damped = std::exp(-0.5 * std::pow(2.0 * M_PI * 2.0 / 25.0, 2));
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(smooth[i], damped * values[i], 0.01);
}

TEST(PathLowPass, KeepsAConstantAndTheRangeOfValues) {
  EXPECT_TRUE(rc::check("a low-pass stays within its values", [] {
    const auto values = *rc::gen::container<std::vector<double>>(
        12, rc::gen::map(rc::gen::inRange(-100, 100), [](int v) { return 0.01 * v; }));
    const auto ends = *rc::gen::element(PathEnds::Reflected, PathEnds::Joined);
    const double sigma = 0.1 * *rc::gen::inRange(1, 400);
    const Stations stations = equalStations(12, 10.0, ends);
    const double low = *std::min_element(values.begin(), values.end());
    const double high = *std::max_element(values.begin(), values.end());
    for (const double v : lowPassed(values, stations, sigma))
      RC_ASSERT(v >= low - 1e-12 && v <= high + 1e-12);
    for (const double v : lowPassed(std::vector<double>(12, 0.37), stations, sigma)) RC_ASSERT(v == 0.37);
  }));
}

TEST(PathLowPass, RefusesStationsThatDoNotAscend) {
  EXPECT_THROW(lowPassed({1, 2}, {{3.0, 2.0}, 10.0}, 1.0), InvalidInput);
  EXPECT_THROW(lowPassed({1, 2}, {{3.0, 12.0}, 10.0}, 1.0), InvalidInput);
  EXPECT_THROW(lowPassed({1}, {{3.0, 4.0}, 10.0}, 1.0), InvalidInput);
}

TEST(PathLowPass, OfALayerMixesNeighbouringBeadsOnly) {
  // Two beads side by side, and a third one 20 mm away.
  const LayerCells cells = test::straightBeads({0.0, 3.0, 23.0}, 60.0, 1.0);
  std::vector<double> values(cells.size(), 0.0);
  for (std::size_t i = cells.runs[1].first; i < cells.runs[1].first + cells.runs[1].count; ++i)
    values[i] = 1.0;
  const auto smooth = lowPassed(values, cells, 3.0);
  const std::size_t middle = cells.runs[0].count / 2;
  EXPECT_GT(smooth[cells.runs[0].first + middle], 0.1);
  EXPECT_LT(smooth[cells.runs[1].first + middle], 0.9);
  EXPECT_EQ(smooth[cells.runs[2].first + middle], 0.0);
}

TEST(PathLowPass, OfASingleBeadIsThatOfItsPath) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 1.0);
  const auto values = cosine(stationsOf(cells, cells.runs[0]), 15.0);
  EXPECT_EQ(lowPassed(values, cells, 3.0), lowPassed(values, stationsOf(cells, cells.runs[0]), 3.0));
}

TEST(PathLowPass, LeavesTheMeanOfAPathThatIsMuchShorterThanIt) {
  // In its taps, or images, such a path would stand billions of times.
  const std::vector<double> even =
      lowPassed({1.0, 2.0, 6.0}, {{0.5e-9, 1.5e-9, 2.5e-9}, 3e-9, PathEnds::Reflected}, 3.0);
  for (const double value : even) EXPECT_NEAR(value, 3.0, 1e-12);
}

}  // namespace
}  // namespace lamina
