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

/// Greatest gain at which a loop as in `greatestStableGain` does not overshoot: D^D / (D + 1)^(D + 1); 1
/// without lag.
double greatestCalmGain(int lag_layers);

/// A trim by a sensor behind the nozzle is stable if its gain times the distance of the sensor is at most
/// `kStableTrim`, and does not overshoot if it is at most `kCalmTrim`.
constexpr double kStableTrim = 1.5707963267948966;  // pi / 2
constexpr double kCalmTrim = 0.36787944117144233;   // 1 / e

/// The parameters that determine how waves of height error along a bead grow from layer to layer.
struct WaveLoop {
  double gain = 0.5;            ///< gain of the loop times actual over learnt growth
  double low_pass_mm = 3.0;     ///< standard deviation of the corrections' low-pass
  double place_error_mm = 0.0;  ///< distance of a correction from its place
  double levelling_mm = 0.0;    ///< standard deviation of the process's own levelling; 0 if not known
  /// Relative loss of growth per layer height by which the nozzle is too far away.
  double standoff = 0.0;
  bool follows_surface = false;  ///< whether the nozzle's height follows the low-passed surface
};

/// Factor by which a wave of height error grows from layer to layer: |B (1 + k (1 - Fz) - g F exp(i w d))|. w
/// is the wave number 2 pi / `wave_mm`. B, F and Fz are the shares of the wave that remain after levelling,
/// after the low-pass, and in the nozzle's height (F if it follows the surface, otherwise 0). k is the
/// stand-off, g the gain and d the place error.
/// @param wave_mm  wavelength; positive; infinite for the mean error
double growthOfWave(const WaveLoop& loop, double wave_mm);

/// The greatest `growthOfWave` over all wavelengths.
double greatestGrowth(const WaveLoop& loop);

/// What was calibrated, and how accurately; the input of the check of stability.
struct LoopCalibration {
  bool has_time_offset = false;      ///< whether the time offset of the sensor is calibrated
  bool has_sensor_place = false;     ///< whether the pose of the sensor at the nozzle is calibrated
  double speed_mm_s = 0.0;           ///< greatest speed at which corrections are deposited
  double delay_uncertainty_s = 0.0;  ///< uncertainty of the delays of feeder and sensor together
  double place_error_mm = 0.0;       ///< error of the calibrated pose along the path
  double bead_width_mm = 0.0;
  double cell_mm = 0.0;
  double levelling_mm = 0.0;  ///< standard deviation of the process's own levelling; 0 if not known
  /// Relative loss of growth per layer height by which the nozzle is too far away.
  double standoff = 0.0;
  double gain_ratio = 1.0;  ///< actual over learnt growth, at worst
  int lag_layers = 0;       ///< number of layers deposited before a measurement has an effect
};

/// Distance of a correction from its place [mm]: speed times uncertainty of the delays, plus the error of the
/// calibrated pose.
double placeErrorOf(const LoopCalibration& calibration);

/// A value and its bound.
struct StabilityBound {
  std::string name;
  double value = 0.0;
  double bound = 0.0;
  bool is_lower = false;  ///< the value must be at least the bound; otherwise at most
  bool holds() const { return is_lower ? value >= bound : value <= bound; }
};

/// The result of a check: whether the loop may start, and with which low-pass.
struct StabilityReport {
  bool may_start = false;
  double low_pass_mm = 0.0;            ///< that of the settings, or the one to which it was raised
  std::vector<StabilityBound> bounds;  ///< all that were checked
  /// Why it may not start, or what an operator has to know of a loop that may: that the low-pass was raised,
  /// that amounts stay as planned. Empty otherwise.
  std::string reason;
};

/// Checks whether the loop may start. It may if
/// - time offset and pose of the sensor are calibrated,
/// - there is something to correct: of a pressed process, whose sections are not read from profiles, that is
///   the height of the nozzle alone, so `loop.z` must not be plan,
/// - gain times gain ratio is below the greatest stable gain without lag,
/// - with a lag, gain times the error of the gain ratio (its distance from 1), which the prediction of the
///   layers under way gets wrong, is below the greatest stable gain with that lag,
/// - trim times gain ratio is below `kStableTrim`,
/// - the low-pass is at least 1.5 place errors, half a bead's width and two cells, and
/// - no wave grows by more than half a percent per layer.
///
/// A low-pass that is too narrow is refused, or raised if the settings say so. The check has to be repeated
/// if the gain changes (`needsNewCheck`).
StabilityReport checkStability(const LoopSettings& settings, const LoopCalibration& calibration);

/// Whether the gain has changed since the check by more than a fifth, so that the check has to be repeated.
bool needsNewCheck(double gain_at_check, double gain);

}  // namespace lamina
