// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/stability.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "base/decimals.hpp"

namespace lamina {
namespace {

constexpr double kPlaceErrors = 1.5;        // that a low-pass is wide at least
constexpr double kGrowthTolerated = 1.005;  // a layer: what 1.5 place errors leave without levelling
constexpr double kNewCheck = 0.2;           // change of the gain
constexpr double kLongestInSigmas = 200.0;
constexpr int kWaves = 4000;
constexpr int kShownDigits = 3;  // of numbers in messages

double gaussian(double omega, double sigma_mm) {
  return std::exp(-0.5 * omega * omega * sigma_mm * sigma_mm);
}

double growthAt(const WaveLoop& loop, double omega) {
  const double low_pass = gaussian(omega, loop.low_pass_mm);
  const double follow = loop.follows_surface ? low_pass : 0.0;
  const std::complex<double> turn = std::polar(1.0, omega * loop.place_error_mm);
  const std::complex<double> kept = 1.0 + loop.standoff * (1.0 - follow) - loop.gain * low_pass * turn;
  return gaussian(omega, loop.levelling_mm) * std::abs(kept);
}

double leastLowPass(const LoopCalibration& calibration) {
  return std::max(
      {kPlaceErrors * placeErrorOf(calibration), 0.5 * calibration.bead_width_mm, 2.0 * calibration.cell_mm});
}

std::string missingCalibration(const LoopCalibration& calibration) {
  if (!calibration.has_time_offset)
    return "the sensor's time offset is not calibrated; expected a calibration";
  if (!calibration.has_sensor_place)
    return "the sensor's place at the nozzle is not calibrated; expected a calibration";
  return {};
}

std::string noteOnAmounts(const LoopSettings& settings) {
  if (settings.process == LoopProcess::Free) return {};
  return "loop.process is pressed: amounts are corrected where profiles show the sections of beads, by five "
         "points across or more";
}

std::string refusal(const StabilityBound& bound) {
  return bound.name + " is " + significantText(bound.value, kShownDigits) + "; expected " +
         (bound.is_lower ? "at least " : "at most ") + significantText(bound.bound, kShownDigits);
}

/// Bounds of gains, which no low-pass mends.
std::vector<StabilityBound> gainBounds(const LoopSettings& settings, const LoopCalibration& calibration) {
  // At the bound itself an error stays for ever.
  constexpr double kBelow = 0.999;
  const double gain = settings.gain * calibration.gain_ratio;
  std::vector<StabilityBound> bounds = {
      {"the loop's gain times real over learnt growth", gain, kBelow * greatestStableGain(0), false}};
  if (calibration.lag_layers > 0)
    bounds.push_back({"the part of the gain that " + std::to_string(calibration.lag_layers) +
                          " layers of prediction mistake",
                      settings.gain * std::abs(calibration.gain_ratio - 1.0),
                      kBelow * greatestStableGain(calibration.lag_layers), false});
  bounds.push_back({"the trim times real over learnt growth", settings.trim * calibration.gain_ratio,
                    kBelow * kStableTrim, false});
  return bounds;
}

WaveLoop waveLoop(const LoopSettings& settings, const LoopCalibration& calibration, double low_pass_mm) {
  return {settings.gain * calibration.gain_ratio,
          low_pass_mm,
          placeErrorOf(calibration),
          calibration.levelling_mm,
          calibration.standoff,
          settings.z == NozzleHeight::Surface};
}

}  // namespace

double greatestStableGain(int lag_layers) {
  return 2.0 * std::cos(lag_layers * M_PI / (2.0 * lag_layers + 1.0));
}

double greatestCalmGain(int lag_layers) {
  const double lag = lag_layers;
  return std::pow(lag, lag) / std::pow(lag + 1.0, lag + 1.0);
}

double growthOfWave(const WaveLoop& loop, double wave_mm) { return growthAt(loop, 2.0 * M_PI / wave_mm); }

double greatestGrowth(const WaveLoop& loop) {
  const double sigma = std::max(loop.low_pass_mm, 1e-6);
  // Beyond eight over the low-pass it does nothing; what levels is less then, and less for shorter waves.
  const double last = 8.0 / sigma;
  double greatest = growthAt(loop, 0.0);
  for (int i = 1; i <= kWaves; ++i) greatest = std::max(greatest, growthAt(loop, last * i / kWaves));
  return std::max(greatest, growthAt(loop, 1.0 / (kLongestInSigmas * sigma)));
}

double placeErrorOf(const LoopCalibration& calibration) {
  return calibration.speed_mm_s * calibration.delay_uncertainty_s + calibration.place_error_mm;
}

StabilityReport checkStability(const LoopSettings& settings, const LoopCalibration& calibration) {
  StabilityReport report;
  report.low_pass_mm = settings.low_pass_mm;
  report.bounds = gainBounds(settings, calibration);
  const double least = leastLowPass(calibration);
  report.bounds.push_back({"the low-pass in mm", settings.low_pass_mm, least, true});
  const bool is_narrow = !report.bounds.back().holds();
  if (is_narrow && settings.narrow_low_pass == NarrowLowPass::Raised) report.low_pass_mm = least;
  report.bounds.push_back({"the growth of the worst wave of error per layer",
                           greatestGrowth(waveLoop(settings, calibration, report.low_pass_mm)),
                           kGrowthTolerated, false});
  report.reason = missingCalibration(calibration);
  for (const StabilityBound& bound : report.bounds) {
    if (!report.reason.empty()) return report;
    const bool is_mended = bound.is_lower && report.low_pass_mm != settings.low_pass_mm;
    if (!bound.holds() && !is_mended) report.reason = refusal(bound);
  }
  report.may_start = report.reason.empty();
  if (!report.may_start) return report;
  report.reason = noteOnAmounts(settings);
  if (report.low_pass_mm == settings.low_pass_mm) return report;
  if (!report.reason.empty()) report.reason += "; ";
  report.reason += "the low-pass of " + significantText(settings.low_pass_mm, kShownDigits) +
                   " mm was raised to " + significantText(report.low_pass_mm, kShownDigits) +
                   " mm: corrections act up to " + significantText(placeErrorOf(calibration), kShownDigits) +
                   " mm off their place";
  return report;
}

bool needsNewCheck(double gain_at_check, double gain) {
  return std::abs(gain - gain_at_check) > kNewCheck * gain_at_check;
}

}  // namespace lamina
