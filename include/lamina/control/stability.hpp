// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// Greatest stable gain of an integrating loop that corrects by what it measured `lag_layers` layers ago, and
/// has not predicted since: 2 cos(D pi / (2 D + 1)) [Levin1976]; 2 for none.
double greatestStableGain(int lag_layers);

/// The gain of the same up to which it does not overshoot: D^D / (D + 1)^(D + 1).
double greatestCalmGain(int lag_layers);

/// Gain times distance of a sensor behind the nozzle up to which a trim by it is stable, and calm.
constexpr double kStableTrim = 1.5707963267948966;  // pi / 2
constexpr double kCalmTrim = 0.36787944117144233;   // 1 / e

/// The loop as waves of error along a bead see it.
struct WaveLoop {
  double gain = 0.5;             ///< real growth over learnt growth, times the loop's gain
  double low_pass_mm = 3.0;      ///< standard deviation of the corrections' low-pass
  double place_error_mm = 0.0;   ///< by which a correction acts off its place
  double levelling_mm = 0.0;     ///< standard deviation of the process's own levelling; 0 if not known
  double standoff = 0.0;         ///< loss of growth per nozzle too far away, in layer heights
  bool follows_surface = false;  ///< the nozzle's height follows the low-passed surface
};

/// Factor by which a wave of error of that length grows from layer to layer:
/// |B (1 + k (1 - Fz) - g F exp(i w d))|.
/// @param wave_mm  positive; infinite for the mean
double growthOfWave(const WaveLoop& loop, double wave_mm);

/// The greatest of these over all waves.
double greatestGrowth(const WaveLoop& loop);

/// What was calibrated, and how well.
struct LoopCalibration {
  bool has_time_offset = false;      ///< of the sensor
  bool has_sensor_place = false;     ///< against the nozzle
  double speed_mm_s = 0.0;           ///< greatest, at which is corrected
  double delay_uncertainty_s = 0.0;  ///< of feeder and sensor
  double place_error_mm = 0.0;       ///< of the calibration
  double bead_width_mm = 0.0;
  double cell_mm = 0.0;
  double levelling_mm = 0.0;  ///< of the process; 0 if not known
  double standoff = 0.0;      ///< loss of growth per nozzle too far away, in layer heights
  double gain_ratio = 1.0;    ///< real over learnt growth, at worst
  int lag_layers = 0;         ///< laid before a measurement can act
};

/// Error of place at which a correction acts [mm]: speed times unknown delay, and the calibration's error.
double placeErrorOf(const LoopCalibration& calibration);

/// A bound, and what it bounds.
struct StabilityBound {
  std::string name;
  double value = 0.0;
  double bound = 0.0;
  bool is_lower = false;  ///< the value must not be below it, instead of above
  bool holds() const { return is_lower ? value >= bound : value <= bound; }
};

/// Whether a loop may start, and with which low-pass.
struct StabilityReport {
  bool may_start = false;
  double low_pass_mm = 0.0;  ///< as set, or raised
  std::vector<StabilityBound> bounds;
  std::string reason;  ///< why not, or why it was raised; empty if all is well
};

/// Checks every bound before the loop may start, and again when the gain has changed by a fifth:
/// calibrations are there; gain times gain ratio; with lag, the part of it that prediction mistakes; the
/// trim; the low-pass against 1.5 place errors, half a bead's width and two cells; no wave grows by more than
/// half a percent a layer. A low-pass that is too narrow is refused, or raised if the settings say so.
StabilityReport checkStability(const LoopSettings& settings, const LoopCalibration& calibration);

/// Whether the gain has changed so much since the check that it has to be made again.
bool needsNewCheck(double gain_at_check, double gain);

}  // namespace lamina
