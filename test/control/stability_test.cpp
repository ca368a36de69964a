// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/stability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lamina/control/layer_law.hpp"
#include "lamina/control/trailing_trim.hpp"
#include "lamina/deposition/growth_plant.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

/// Error after many layers of e' = e - g e(D layers ago), from 1.
double laggedError(double gain, int lag_layers, int layers) {
  std::vector<double> errors(static_cast<std::size_t>(lag_layers) + 1, 1.0);
  for (int k = 0; k < layers; ++k)
    errors.push_back(errors.back() - gain * errors[errors.size() - 1 - static_cast<std::size_t>(lag_layers)]);
  double last = 0.0;
  for (std::size_t i = errors.size() - 20; i < errors.size(); ++i) last = std::max(last, std::abs(errors[i]));
  return last;
}

TEST(Stability, OfALaggingLoopIsAtItsBound) {
  for (const int lag : {0, 1, 2, 4}) {
    const double bound = greatestStableGain(lag);
    EXPECT_LT(laggedError(0.95 * bound, lag, 1000), 1e-3) << lag;
    EXPECT_GT(laggedError(1.05 * bound, lag, 1000), 1e3) << lag;
  }
  EXPECT_NEAR(greatestStableGain(1), 1.0, 1e-12);
  EXPECT_NEAR(greatestStableGain(2), 0.618, 1e-3);
}

TEST(Stability, IsCalmBelowItsBound) {
  EXPECT_EQ(greatestCalmGain(0), 1.0);
  EXPECT_EQ(greatestCalmGain(1), 0.25);
  EXPECT_NEAR(greatestCalmGain(2), 4.0 / 27.0, 1e-15);
  for (const int lag : {1, 2}) {
    double least = 1.0;
    for (int layers = 30; layers < 60; ++layers) {
      std::vector<double> errors(static_cast<std::size_t>(lag) + 1, 1.0);
      for (int k = 0; k < layers; ++k)
        errors.push_back(errors.back() - 0.95 * greatestCalmGain(lag) *
                                             errors[errors.size() - 1 - static_cast<std::size_t>(lag)]);
      least = std::min(least, errors.back());
    }
    EXPECT_GE(least, 0.0);
  }
}

/// The real law on the real plant, with a gain by which a layer corrects too much.
TEST(Stability, OfTheLawIsAtTwiceTheGain) {
  for (const double share : {0.95, 1.05}) {
    const LayerCells cells = test::straightBeads({0.0}, 40.0, 1.0);
    LoopSettings settings;
    settings.gain = share * greatestStableGain(0);
    settings.least_amount = -0.95;
    settings.greatest_amount = settings.layer_volume = 5.0;
    settings.feeder_rate_s = 1000.0;
    LayerKnowledge known{std::vector<double>(cells.size(), 0.01), std::vector<double>(cells.size(), 1.0)};
    for (int k = 0; k < 60; ++k) {
      const auto amount = freeCorrection(cells, known, settings).amount;
      for (std::size_t i = 0; i < cells.size(); ++i) known.error_mm[i] -= 1.5 * amount[i];
    }
    const double last = std::abs(known.error_mm[20]);
    EXPECT_TRUE(share < 1.0 ? last < 0.001 : last > 0.1) << last;
  }
}

/// A trim that predicts nothing, of a sensor behind the nozzle, on an error that a step has brought.
double trimmedError(double trim) {
  TrimSettings settings;
  settings.behind_mm = 40.0;
  settings.step_mm = 0.1;
  settings.growth = 0.0;
  settings.gain_per_mm = trim / settings.behind_mm;
  settings.range = 1e9;
  TrailingTrim loop(settings);
  std::vector<double> errors;
  constexpr int kSteps = 40000;
  const std::size_t behind = 400;
  for (int i = 0; i < kSteps; ++i) {
    const double seen = errors.size() < behind ? 0.0 : errors[errors.size() - behind];
    errors.push_back(0.1 + loop.advance(seen));
  }
  double last = 0.0;
  for (std::size_t i = errors.size() - 4000; i < errors.size(); ++i)
    last = std::max(last, std::abs(errors[i]));
  return last;
}

TEST(Stability, OfATrimWithoutPredictionIsAtItsBound) {
  EXPECT_LT(trimmedError(0.95 * kStableTrim), 0.01);
  EXPECT_GT(trimmedError(1.05 * kStableTrim), 1.0);
}

/// Amplitude after a layer over that before, of a wave round a closed bead, by law and plant.
double grownWave(const WaveLoop& wave, double waves, double length_mm) {
  ToolpathLayer layer = test::straightBeadLayer({0.0}, length_mm);
  LayerCells cells = layerCells(layer, 0, 0.25);
  cells.runs[0].is_closed = true;
  LoopSettings settings;
  settings.gain = wave.gain;
  settings.low_pass_mm = wave.low_pass_mm;
  settings.feeder_rate_s = 1000.0;
  settings.least_amount = -0.9;
  settings.greatest_amount = settings.layer_volume = 5.0;
  PlantSettings plant;
  plant.levelling_mm = wave.levelling_mm;
  plant.standoff = wave.standoff;
  plant.nozzle_offset_mm = {wave.place_error_mm, 0.0, 0.0};
  std::vector<double> error;
  for (const double s : cells.along_mm) error.push_back(1e-3 * std::cos(2.0 * M_PI * waves * s / length_mm));
  PlantBead bead;
  bead.length_mm = length_mm;
  bead.is_closed = true;
  bead.along_mm = cells.along_mm;
  bead.planned_mm = cells.height_mm;
  bead.nozzle_far_mm = error;
  bead.correction = freeCorrection(cells, {error, std::vector<double>(cells.size(), 1.0)}, settings).amount;
  std::vector<double> heights;
  for (const double e : error) heights.push_back(-e);
  heights = GrowthPlant(plant).afterBead(bead, heights);
  double greatest = 0.0;
  for (const double height : heights) greatest = std::max(greatest, std::abs(1.5 - height));
  return greatest / 1e-3;
}

TEST(Stability, OfWavesIsThatOfLawAndPlant) {
  constexpr double kWaveLength = 100.0;
  for (const double place : {0.0, 2.0, 5.0})
    for (const double levelling : {0.0, 1.0})
      for (const double standoff : {0.0, 0.3})
        for (const double waves : {1.0, 4.0, 10.0}) {
          const WaveLoop loop{0.5, 3.0, place, levelling, standoff, false};
          EXPECT_NEAR(grownWave(loop, waves, kWaveLength), growthOfWave(loop, kWaveLength / waves), 0.01)
              << place << " " << levelling << " " << standoff << " " << waves;
        }
}

TEST(Stability, OfWavesTurnsAtTheirBound) {
  // The gain at which the worst wave of a low-pass of 3 mm stays as it is; 100 mm have whole waves near it.
  const auto worst = [](double gain) { return WaveLoop{gain, 3.0, 2.0, 1.0, 0.0, false}; };
  double low = 0.5;
  double high = 4.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (greatestGrowth(worst(middle)) > 1.0 ? high : low) = middle;
  }
  const auto grown = [&](double gain) {
    double greatest = 0.0;
    for (int waves = 0; waves <= 30; ++waves)
      greatest = std::max(greatest, grownWave(worst(gain), waves, 100.0));
    return greatest;
  };
  EXPECT_LT(grown(0.95 * low), 1.0);
  EXPECT_GT(grown(1.05 * low), 1.0);
}

TEST(Stability, GrowsByTheFiguresOfNarrowLowPasses) {
  const auto growth = [](double place_errors) {
    return greatestGrowth({0.5, 3.0, 3.0 / place_errors, 0, 0, false});
  };
  EXPECT_NEAR(growth(1.5), 1.003, 5e-4);
  EXPECT_NEAR(growth(1.0), 1.03, 5e-4);
  EXPECT_NEAR(growth(0.6), 1.14, 5e-3);
  EXPECT_LT(greatestGrowth({0.5, 3.0, 0.0, 1.0, 0.3, true}), 1.0);
  EXPECT_GT(greatestGrowth({0.5, 3.0, 0.0, 1.0, 0.6, true}), 1.0);
  EXPECT_LT(greatestGrowth({0.5, 3.0, 0.0, 2.0, 0.6, true}), 1.0);
}

LoopCalibration calibrated() {
  LoopCalibration calibration;
  calibration.has_time_offset = calibration.has_sensor_place = true;
  calibration.speed_mm_s = 10.0;
  calibration.bead_width_mm = 3.0;
  calibration.cell_mm = 0.5;
  return calibration;
}

TEST(Stability, LetsACalibratedLoopStart) {
  const StabilityReport report = checkStability(LoopSettings(), calibrated());
  EXPECT_TRUE(report.may_start) << report.reason;
  EXPECT_EQ(report.low_pass_mm, 3.0);
  EXPECT_EQ(report.reason, "");
}

TEST(Stability, RefusesWhatIsNotCalibrated) {
  LoopCalibration calibration = calibrated();
  calibration.has_time_offset = false;
  EXPECT_FALSE(checkStability(LoopSettings(), calibration).may_start);
  calibration = calibrated();
  calibration.has_sensor_place = false;
  EXPECT_FALSE(checkStability(LoopSettings(), calibration).may_start);
}

/// The sections of beads, which amounts would follow from, are not measured.
TEST(Stability, StartsAPressedProcessByItsSections) {
  LoopSettings pressed;
  pressed.process = LoopProcess::Pressed;
  for (const NozzleHeight z : {NozzleHeight::Plan, NozzleHeight::Layer}) {
    pressed.z = z;
    const StabilityReport started = checkStability(pressed, calibrated());
    EXPECT_TRUE(started.may_start) << started.reason;
    EXPECT_NE(started.reason.find("five points across"), std::string::npos) << started.reason;
  }
}

TEST(Stability, RefusesOrRaisesANarrowLowPass) {
  LoopCalibration calibration = calibrated();
  calibration.delay_uncertainty_s = 0.8;
  calibration.place_error_mm = 0.5;
  EXPECT_NEAR(placeErrorOf(calibration), 8.5, 1e-12);
  const StabilityReport refused = checkStability(LoopSettings(), calibration);
  EXPECT_FALSE(refused.may_start);
  EXPECT_EQ(refused.reason, "the low-pass in mm is 3; expected at least 12.8");
  LoopSettings raising;
  raising.narrow_low_pass = NarrowLowPass::Raised;
  const StabilityReport raised = checkStability(raising, calibration);
  EXPECT_TRUE(raised.may_start) << raised.reason;
  EXPECT_NEAR(raised.low_pass_mm, 12.75, 1e-12);
  EXPECT_NE(raised.reason.find("raised to 12.8 mm"), std::string::npos);
}

TEST(Stability, RefusesGainsThatAreNotStable) {
  LoopCalibration calibration = calibrated();
  calibration.gain_ratio = 4.5;
  EXPECT_FALSE(checkStability(LoopSettings(), calibration).may_start);
  calibration.gain_ratio = 2.0;
  EXPECT_TRUE(checkStability(LoopSettings(), calibration).may_start);
  calibration.lag_layers = 2;
  EXPECT_TRUE(checkStability(LoopSettings(), calibration).may_start) << "half of 1 is below 0.62";
  calibration.gain_ratio = 2.5;
  EXPECT_FALSE(checkStability(LoopSettings(), calibration).may_start);
  LoopSettings trimmed;
  trimmed.trim = 0.9;
  calibration = calibrated();
  calibration.gain_ratio = 2.0;
  EXPECT_FALSE(checkStability(trimmed, calibration).may_start);
  calibration.gain_ratio = 1.0;
  calibration.standoff = 0.3;
  EXPECT_FALSE(checkStability(LoopSettings(), calibration).may_start) << "no levelling is known";
}

TEST(Stability, IsCheckedAgainWhenTheGainHasChanged) {
  EXPECT_FALSE(needsNewCheck(0.9, 1.0));
  EXPECT_TRUE(needsNewCheck(0.9, 1.1));
  EXPECT_TRUE(needsNewCheck(0.9, 0.7));
}

}  // namespace
}  // namespace lamina
