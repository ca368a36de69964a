// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// Greatest stable gain of an integrating loop whose measurements are D = `lag_layers` layers old, without
/// prediction: 2 cos(D pi / (2 D + 1)) [Levin1976]; 2 without lag.
double greatestStableGain(int lag_layers);

/// Greatest gain at which the same loop does not overshoot: D^D / (D + 1)^(D + 1).
double greatestCalmGain(int lag_layers);

/// Gain times distance of a sensor behind the nozzle up to which a trim by it is stable, and up to which it
/// does not overshoot.
constexpr double kStableTrim = 1.5707963267948966;  // pi / 2
constexpr double kCalmTrim = 0.36787944117144233;   // 1 / e

/// The parameters of the loop on which the growth of waves of error along a bead depends.
struct WaveLoop {
  double gain = 0.5;             ///< gain of the loop times actual over learnt growth
  double low_pass_mm = 3.0;      ///< standard deviation of the corrections' low-pass
  double place_error_mm = 0.0;   ///< distance of a correction from its place
  double levelling_mm = 0.0;     ///< standard deviation of the process's own levelling; 0 if not known
  double standoff = 0.0;         ///< relative loss of growth per layer height that the nozzle is too far away
  bool follows_surface = false;  ///< the nozzle's height follows the low-passed surface
};

/// Factor by which a wave of error grows from layer to layer: |B (1 + k (1 - Fz) - g F exp(i w d))|. w is its
/// wave number, B what levelling leaves of it, k the stand-off, Fz what the nozzle's height follows of it, g
/// the gain, F what the low-pass leaves of it, and d the place error.
/// @param wave_mm  wavelength; positive; infinite for the mean error
double growthOfWave(const WaveLoop& loop, double wave_mm);

/// The greatest `growthOfWave` of all wavelengths.
double greatestGrowth(const WaveLoop& loop);

/// What was calibrated, and how accurately.
struct LoopCalibration {
  bool has_time_offset = false;      ///< of the sensor
  bool has_sensor_place = false;     ///< relative to the nozzle
  double speed_mm_s = 0.0;           ///< greatest speed at which corrections are deposited
  double delay_uncertainty_s = 0.0;  ///< of feeder and sensor
  double place_error_mm = 0.0;       ///< of the calibration
  double bead_width_mm = 0.0;
  double cell_mm = 0.0;
  double levelling_mm = 0.0;  ///< of the process; 0 if not known
  double standoff = 0.0;      ///< relative loss of growth per layer height that the nozzle is too far away
  double gain_ratio = 1.0;    ///< actual over learnt growth, worst case
  int lag_layers = 0;         ///< number deposited before a measurement can act
};

/// Distance of a correction from its place [mm]: speed times uncertainty of delay, plus the place error of
/// the calibration.
double placeErrorOf(const LoopCalibration& calibration);

/// A value and its bound.
struct StabilityBound {
  std::string name;
  double value = 0.0;
  double bound = 0.0;
  bool is_lower = false;  ///< the value must be at least the bound; else at most
  bool holds() const { return is_lower ? value >= bound : value <= bound; }
};

/// Whether a loop may start, and with which low-pass.
struct StabilityReport {
  bool may_start = false;
  double low_pass_mm = 0.0;  ///< as in the settings, or raised
  std::vector<StabilityBound> bounds;
  std::string reason;  ///< why not, or why it was raised; empty if all is well
};

/// Checks all conditions of stability before the loop may start, and again when the gain has changed
/// (`needsNewCheck`): that calibrations exist; that the gain times the gain ratio is within its bounds, as is
/// the part of it that prediction gets wrong, with its lag; that the trim is within its bound; that the
/// low-pass is at least 1.5 place errors, half a bead's width and two cells; and that no wave grows by more
/// than half a percent per layer. A low-pass that is too narrow is refused, or raised if the settings say so.
StabilityReport checkStability(const LoopSettings& settings, const LoopCalibration& calibration);

/// Whether the gain has changed since the check by more than a fifth, so that it has to be repeated.
bool needsNewCheck(double gain_at_check, double gain);

}  // namespace lamina
