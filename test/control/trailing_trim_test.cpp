// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/trailing_trim.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kStep = 0.5;  // mm

/// Root mean square of the relative error along a layer of 6 m, on a drift that the layers before cannot have
/// shown: waves of 3 to 5 m, which are minutes, of a random phase.
double drifted(double trim, double behind_mm, double growth, std::uint64_t seed) {
  Random random(seed);
  const double wave_mm = random.uniform(3000.0, 5000.0);
  const double phase = random.uniform(0.0, 2.0 * M_PI);
  TrimSettings settings;
  settings.behind_mm = behind_mm;
  settings.step_mm = kStep;
  settings.gain_per_mm = trim / behind_mm;
  settings.range = 1.0;
  TrailingTrim loop(settings);
  const auto behind = static_cast<std::size_t>(std::lround(behind_mm / kStep));
  std::vector<double> errors;
  double squares = 0.0;
  for (int i = 0; i < 12000; ++i) {
    const double drift = 0.05 * std::sin(2.0 * M_PI * kStep * i / wave_mm + phase);
    const bool sees = errors.size() >= behind;
    const double amount =
        loop.advance(sees ? std::optional<double>(errors[errors.size() - behind]) : std::nullopt);
    errors.push_back(drift + growth * (trim > 0.0 ? amount : 0.0));
    squares += errors.back() * errors.back();
  }
  return std::sqrt(squares / static_cast<double>(errors.size()));
}

double meanDrifted(double trim, double behind_mm, double growth) {
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) sum += drifted(trim, behind_mm, growth, seed) / 5.0;
  return sum;
}

TEST(TrailingTrim, TakesASixthOffASlowDriftAtLeast) {
  for (const double behind_mm : {25.0, 60.0})
    EXPECT_LT(meanDrifted(0.18, behind_mm, 1.0), 0.85 * meanDrifted(0.0, behind_mm, 1.0)) << behind_mm;
}

TEST(TrailingTrim, DoesNotOscillateAtTwiceTheGrowth) {
  TrimSettings settings;
  settings.behind_mm = 60.0;
  settings.step_mm = kStep;
  settings.gain_per_mm = 0.18 / 60.0;
  TrailingTrim loop(settings);
  std::vector<double> errors;
  double least = 1.0;
  for (int i = 0; i < 10000; ++i) {
    const bool sees = errors.size() >= 120;
    const double amount =
        loop.advance(sees ? std::optional<double>(errors[errors.size() - 120]) : std::nullopt);
    errors.push_back(0.1 + 2.0 * amount);
    least = std::min(least, errors.back());
  }
  EXPECT_GT(least, -0.01) << "overshoot of a step of 0.1";
  EXPECT_NEAR(errors.back(), 0.0, 1e-3);
}

TEST(TrailingTrim, StaysWhereNothingIsSeen) {
  TrimSettings settings;
  settings.behind_mm = 10.0;
  settings.gain_per_mm = 0.01;
  TrailingTrim loop(settings);
  EXPECT_NEAR(loop.advance(0.2), -0.01 * 0.5 * 0.2, 1e-15);
  const double before = loop.trim();
  EXPECT_EQ(loop.advance(std::nullopt), before);
  EXPECT_EQ(loop.advance(std::nan("")), before);
  EXPECT_EQ(loop.advance(std::numeric_limits<double>::infinity()), before);
}

TEST(TrailingTrim, StaysWithinItsRange) {
  TrimSettings settings;
  settings.behind_mm = 10.0;
  settings.gain_per_mm = 10.0;
  TrailingTrim loop(settings);
  EXPECT_EQ(loop.advance(5.0), -0.2);
}

TEST(TrailingTrim, RefusesASensorThatIsNotBehind) {
  TrimSettings settings;
  EXPECT_THROW(TrailingTrim{settings}, InvalidInput);
  settings.behind_mm = 25.0;
  settings.step_mm = 0.0;
  EXPECT_THROW(TrailingTrim{settings}, InvalidInput);
}

}  // namespace
}  // namespace lamina
